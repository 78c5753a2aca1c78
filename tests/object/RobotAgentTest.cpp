// SPDX-License-Identifier: Apache-2.0
// The whole object of a robot over sticks in folders: it plays as a good one says, and over a bad
// one it stays lying, tells why in one line and blinks the fault's number.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "robot/body/Lights.h"
#include "tests/object/PlayedStick.h"

namespace kelpie::object {
namespace {

using stick::StickFault;
using stick::StickTree;

constexpr std::uint32_t kFaceLights = ((1U << body::kFaceLights) - 1U) << body::kFirstFaceLight;

int lines(const std::string& text) {
  return static_cast<int>(std::count(text.begin(), text.end(), '\n'));
}

TEST(RobotAgent, PlaysOverAGoodStickAsTheStickSays) {
  const Played result = played(folderOf(stick::sampleTree(), "good"));
  EXPECT_GT(std::fabs(result.lastKnee), 5.0) << "it stands up; the joints were sensed at 0";
  EXPECT_EQ(result.leds.back() & body::kLightBackFront, body::kLightBackFront) << "blue";
  EXPECT_EQ(result.leds.back() & body::kLightBackRear, 0U);
  EXPECT_EQ(result.leds.back() & body::kLightBackMiddle, body::kLightBackMiddle) << "no Python";
  EXPECT_EQ(result.leds.back() & body::kLightRed, 0U);
  EXPECT_NE(result.log.find("STICK.BIN: is good; player 3, simple"), std::string::npos)
      << result.log;
}

TEST(RobotAgent, ShowsThatItReadsThenThatPythonStartsThenThatItWaits) {
  const Played result = played(folderOf(stick::sampleTree(), "boot"));
  std::vector<std::uint32_t> reported;
  for (const std::uint32_t leds : result.leds) {
    const std::uint32_t boot = leds & (body::kLightReading | body::kLightPython);
    if (reported.empty() || reported.back() != boot) reported.push_back(boot);
  }
  const std::uint32_t both = body::kLightReading | body::kLightPython;
  EXPECT_EQ(reported, (std::vector<std::uint32_t>{0, body::kLightReading, both, 0}));
}

struct Damage {
  const char* name;
  StickFault fault;
  const char* file;
  void (*make)(StickTree& tree);
};

std::string& bytesOf(StickTree& tree, const std::string& path) {
  for (auto& file : tree)
    if (file.path == path) return file.bytes;
  ADD_FAILURE() << path;
  return tree.front().bytes;
}

void without(StickTree& tree, const std::string& path) {
  tree.erase(
      std::remove_if(tree.begin(), tree.end(), [&](const auto& file) { return file.path == path; }),
      tree.end());
}

constexpr const char* kScripts = "OPEN-R/MW/DATA/P/PYCODE.ZIP";
constexpr const char* kProgram = "OPEN-R/MW/OBJS/AGENT.BIN";

const Damage kDamages[] = {
    {"empty", StickFault::missing, stick::kStickPath, [](StickTree& tree) { tree.clear(); }},
    {"no_program", StickFault::missing, kProgram, [](StickTree& tree) { without(tree, kProgram); }},
    {"magic", StickFault::wrongMagic, stick::kStickPath,
     [](StickTree& tree) { bytesOf(tree, stick::kStickPath)[0] ^= 1; }},
    {"cut", StickFault::cutShort, stick::kStickPath,
     [](StickTree& tree) {
       std::string& bytes = bytesOf(tree, stick::kStickPath);
       bytes.resize(bytes.size() / 2);
     }},
    {"part", StickFault::damagedPart, stick::kStickPath,
     [](StickTree& tree) {
       std::string& bytes = bytesOf(tree, stick::kStickPath);
       bytes[bytes.size() / 2] ^= 16;
     }},
    {"long", StickFault::tooLong, stick::kStickPath,
     [](StickTree& tree) { bytesOf(tree, stick::kStickPath) += '\0'; }},
    {"scripts", StickFault::otherContent, kScripts,
     [](StickTree& tree) { bytesOf(tree, kScripts)[7] ^= 1; }},
};

class RobotAgentOver : public testing::TestWithParam<Damage> {};

TEST_P(RobotAgentOver, ADamagedStickStaysLyingAndBlinksTheFault) {
  const Damage& damage = GetParam();
  StickTree tree = stick::sampleTree();
  damage.make(tree);
  const Played result = played(folderOf(tree, damage.name));
  const stick::StickVerdict verdict{damage.fault, stick::StickPath(std::string_view(damage.file))};
  EXPECT_EQ(lines(result.log), 1);
  EXPECT_NE(result.log.find(stick::lineOf(verdict).view()), std::string::npos) << result.log;
  EXPECT_FALSE(result.motorPower);
  EXPECT_EQ(result.gains, 0U);
  int changes = 0;
  const auto isRead = [](std::uint32_t leds) { return leds != body::kLightReading && leds != 0; };
  const auto begin = std::find_if(result.leds.begin(), result.leds.end(), isRead);
  const auto first = static_cast<std::size_t>(begin - result.leds.begin());
  ASSERT_LT(first, 20U) << "messages until the stick is refused";
  for (std::size_t i = first + 1; i < result.leds.size(); ++i) {
    EXPECT_EQ(result.leds[i] & kFaceLights,
              body::faultLights(static_cast<std::uint32_t>(damage.fault), {}) & kFaceLights);
    EXPECT_EQ(result.leds[i] & ~(kFaceLights | body::kLightRed), 0U);
    changes += ((result.leds[i] ^ result.leds[i - 1]) & body::kLightRed) != 0 ? 1 : 0;
  }
  EXPECT_GE(changes, 10) << "3.2 s have 12.8 halves of a blink, some before the fault is known";
  EXPECT_LE(changes, 14);
}

INSTANTIATE_TEST_SUITE_P(Sticks, RobotAgentOver, testing::ValuesIn(kDamages),
                         [](const auto& damage) { return std::string(damage.param.name); });

}  // namespace
}  // namespace kelpie::object
