// SPDX-License-Identifier: Apache-2.0
// Orders and numbers of the robot by literals: which light a command lights, in which row of an
// image a plane lies, what a power bit means. Nothing here asks the tables that the agent is made
// of.
#include <gtest/gtest.h>

#include <cstring>
#include <set>
#include <string>

#include "robot/body/Lights.h"
#include "robot/host/primitives/DataVectors.h"
#include "tests/openr/OpenedRobot.h"

namespace kelpie::openr {
namespace {

using Lit = std::set<std::string>;

// The last of the letters of a light's locator, for each that is on: l3 or la.
Lit litBy(std::uint32_t leds) {
  OpenedRobot robot;
  JointFrame frame;
  frame.leds = leds;
  OCommandVectorData& vector = robot.commanded(frame);
  Lit lit;
  for (const LightRow& row : kLightRows) {
    const OPrimitiveID id = robot.open(row.locator);
    for (int i = 0; i < static_cast<int>(vector.vectorInfo.numData); ++i) {
      if (vector.GetInfo(i)->primitiveID != id) continue;
      // The intensity of an LED3 and the state of an LED2 both begin the value.
      if ((vector.GetData(i)->value[0].value[0] & 0xffff) == 0) continue;
      lit.insert(std::string(row.locator).substr(std::strlen(row.locator) - 2));
    }
  }
  return lit;
}

TEST(RawOrders, TheGamesStateIsOverTheEars) {
  EXPECT_EQ(Lit{}, litBy(body::lightsOf(PlayState::initial, false)));
  EXPECT_EQ(Lit{"l5"}, litBy(body::lightsOf(PlayState::ready, false)));
  EXPECT_EQ((Lit{"l3", "l4"}), litBy(body::lightsOf(PlayState::set, false)));
  EXPECT_EQ(Lit{"l4"}, litBy(body::lightsOf(PlayState::playing, false)));
  EXPECT_EQ((Lit{"l3", "l4", "l5"}), litBy(body::lightsOf(PlayState::finished, false)));
  EXPECT_EQ(Lit{"l3"}, litBy(body::lightsOf(PlayState::playing, true)));
}

TEST(RawOrders, TheTeamsColourIsOnTheBack) {
  EXPECT_EQ(Lit{"ly"}, litBy(body::lightsOf(TeamColour::red)));
  EXPECT_EQ(Lit{"lu"}, litBy(body::lightsOf(TeamColour::blue)));
  EXPECT_EQ(Lit{"lw"}, litBy(body::kLightBackMiddle));
}

TEST(RawOrders, RolesAndFaultsAreOnTheFaceFromTheFirst) {
  EXPECT_EQ((Lit{"la", "lb"}), litBy(body::lightsOf(Role::attacker)));
  EXPECT_EQ((Lit{"li", "lj"}), litBy(body::lightsOf(Role::goalie)));
  EXPECT_EQ((Lit{"l3", "la", "lb", "lc"}), litBy(body::faultLights(3, TimeUs{})));
  EXPECT_EQ((Lit{"lk", "ll"}), litBy(body::lightsOf(Rest::paused)));
  EXPECT_EQ(Lit{"lm"}, litBy(body::lightsOf(Rest::batteryLow)));
  EXPECT_EQ(Lit{"ln"}, litBy(body::lightsOf(Rest::blind)));
}

TEST(RawOrders, FaceLightsAreInModeAAndThoseOfTheBackInNone) {
  OpenedRobot robot;
  OCommandVectorData& vector = robot.commanded({});
  for (std::size_t i = 6; i < kLedCount; ++i) {
    const auto place = static_cast<int>(agent::kFirstLed + i);
    const auto first = static_cast<std::uint32_t>(vector.GetData(place)->value[0].value[0]);
    EXPECT_EQ(263U, vector.GetInfo(place)->type);
    EXPECT_EQ(kLightRows[i].locator[5] == 'r' ? 0U : 0xffffU, first >> 16U) << i;
  }
}

TEST(RawOrders, EarsAreUpInStateOneLeftThenRight) {
  OpenedRobot robot;
  JointFrame frame;
  frame.ears.leftUp = true;
  OCommandVectorData& vector = robot.commanded(frame);
  const auto state = [&](const char* locator) {
    const OPrimitiveID id = robot.open(locator);
    int i = 0;
    while (vector.GetInfo(i)->primitiveID != id) ++i;
    EXPECT_EQ(262U, vector.GetInfo(i)->type);
    return vector.GetData(i)->value[0].value[0];
  };
  EXPECT_EQ(1, state("PRM:/r1/c1/c2/c3/e5-Joint4:15"));
  EXPECT_EQ(0, state("PRM:/r1/c1/c2/c3/e6-Joint4:16"));
}

// A line of an orange ball: 208 bytes of Y, then of Cr, then of Cb.
class RawImage : public testing::TestWithParam<int> {
 protected:
  ~RawImage() override { region_->RemoveReference(); }
  OFbkImageVectorData& vector() { return *reinterpret_cast<OFbkImageVectorData*>(region_->Base()); }
  void SetUp() override {
    ASSERT_EQ(GetParam() == 6 ? 24U : 19U, vector().GetInfo(0)->type);
    byte* rows = vector().GetData(0);
    for (int line = 0; line < 160; ++line) {
      byte* row = rows + line * GetParam() * 208;
      std::memset(row, 140, 208);
      std::memset(row + 208, 181, 208);
      std::memset(row + 416, 79, 208);
    }
  }
  RCRegion* region_ = host::newImageRegion(GetParam() == 6);
};

TEST_P(RawImage, RowsAreYThenCrThenCb) {
  Image image;
  ASSERT_TRUE(agent::readImage(vector(), image));
  for (const int column : {0, 100, 207}) {
    EXPECT_EQ(140, image.pixel(column, 80).y);
    EXPECT_EQ(181, image.pixel(column, 80).cr);
    EXPECT_EQ(79, image.pixel(column, 80).cb);
  }
}

INSTANTIATE_TEST_SUITE_P(RowsOfALine, RawImage, testing::Values(3, 6));

agent::PowerReport reportOf(longword robot, word battery) {
  OPowerStatus status;
  status.robotStatus = robot;
  status.batteryStatus = battery;
  return agent::reportOf(status);
}

TEST(RawOrders, PowerBitsByTheirNumbers) {
  EXPECT_TRUE(reportOf(0x1, 0).paused);
  EXPECT_TRUE(reportOf(0x2, 0).motorPower);
  EXPECT_TRUE(reportOf(0x200, 0).batteryLow);
  EXPECT_TRUE(reportOf(0x400, 0).overCurrent);
  EXPECT_TRUE(reportOf(0x800, 0).hot);
  EXPECT_TRUE(reportOf(0x10000, 0).fanFault);
  EXPECT_TRUE(reportOf(0, 0x800).batteryLow);
  EXPECT_TRUE(reportOf(0, 0x1000).hot);
}

TEST(RawOrders, EveryOtherPowerBitMeansNothing) {
  constexpr longword kMeant = 0x1 | 0x2 | 0x200 | 0x400 | 0x800 | 0x10000;
  constexpr word kBatteryMeant = 0x800 | 0x1000;
  const agent::PowerReport report =
      reportOf(~kMeant, static_cast<word>(~static_cast<unsigned>(kBatteryMeant)));
  EXPECT_FALSE(report.paused || report.batteryLow || report.overCurrent || report.hot ||
               report.fanFault || report.motorPower);
}

}  // namespace
}  // namespace kelpie::openr
