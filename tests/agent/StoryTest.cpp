// SPDX-License-Identifier: Apache-2.0
// A robot from switching on to switching off, through the OPEN-R object, the loops and the power
// service of the stand-in: which calls it makes of power and gains, in which order, and how fast a
// joint is asked to move before it plays.
#include "tests/agent/Story.h"

namespace kelpie::agent {
namespace {

TEST_F(Story, StartsLimpThenPowerThenOneGainAfterTheOtherAndStaysAsFoundUntilAskedTo) {
  play(4.0);
  ASSERT_FALSE(system_->calls.empty());
  EXPECT_EQ(system_->calls.front().what, "limp all");
  EXPECT_LT(called("limp all"), called("power on") + 1e-9);
  EXPECT_LT(called("power on"), called("hold 0"));
  expectGainsInTurn(0.0, 4.0);
  EXPECT_EQ(rests.back().rest, Rest::unasked);
  const JointAngles found = desk::sprawled();
  for (const auto& [when, raw] : desk_.played)
    for (std::size_t j = 0; j < kJointCount; ++j)
      ASSERT_NEAR(host::anglesOf(raw).angle[j].rad(), found.angle[j].rad(), 2e-6) << when.seconds();
}

TEST_F(Story, AGainComesInSteps) {
  play(2.0);
  std::vector<int> steps;
  for (const auto& call : system_->calls)
    if (call.what.rfind("gain 4 ", 0) == 0) steps.push_back(std::stoi(call.what.substr(7)));
  EXPECT_EQ(steps, (std::vector<int>{7, 14, 21, 28})) << "a quarter of the standard gain each";
}

TEST_F(Story, AShortPressOfTheHeadRaisesItAndNoJointIsFasterThanAPersonsHand) {
  press(2.0, 0.3);
  play(8.0);
  EXPECT_EQ(rests.back().rest, Rest::none);
  ASSERT_GT(readyAt, 2.2);
  EXPECT_LE(fastest(desk_, 0.0, readyAt), kGentle);
  EXPECT_GT(fastest(desk_, 0.0, readyAt), 50.0) << "it did move";
}

TEST_F(Story, AJamLeavesItLimpAndTheWayBackBeginsAtTheSensedJoints) {
  press(2.0, 0.3);
  at(7.0, [this] {
    system_->jam();
    desk_.frame.joints[Joint::leftHindKnee] = Angle::deg(110.0);  // it sank
    desk_.frame.joints[Joint::rightFrontShoulder] = Angle::deg(70.0);
  });
  at(8.0, [this] { system_->giveBack(); });
  play(14.0);
  EXPECT_GT(called("limp all", 7.0), 0.0);
  EXPECT_GT(restedFrom(Rest::powerless), 6.9);
  expectGainsInTurn(7.0, 14.0);
  EXPECT_GT(called("hold 0", 7.0), 8.0);
  const double again = restedFrom(Rest::none, 8.0);
  ASSERT_GT(again, 8.0);
  EXPECT_LE(fastest(desk_, 8.0, again + 1.0), kGentle);
  EXPECT_EQ(rests.back().rest, Rest::none);
}

TEST_F(Story, PowerThatDoesNotComeBackIsAskedForWhenTheHeadIsPressed) {
  press(2.0, 0.3);
  at(7.0, [this] { system_->jam(); });
  press(9.0, 0.3);
  play(13.0);
  EXPECT_GT(called("power on", 7.0), 8.9);
  EXPECT_EQ(rests.back().rest, Rest::none);
}

TEST_F(Story, AShortPauseLiesDownAndStandsUpAgain) {
  press(2.0, 0.3);
  say(7.0, orsbPAUSE);
  say(8.0, 0);
  play(15.0);
  EXPECT_GT(restedFrom(Rest::paused), 6.9);
  EXPECT_EQ(rests.back().rest, Rest::none);
  EXPECT_EQ(called("shut down"), -1.0);
  EXPECT_LE(fastest(desk_, 7.0 + kInFlight, restedFrom(Rest::none, 8.0) + 1.0), kGentle);
}

TEST_F(Story, APauseThatIsHeldSwitchesTheRobotOff) {
  press(2.0, 0.3);
  say(7.0, orsbPAUSE);
  play(15.0);
  const double off = called("power off", 7.0);
  ASSERT_GT(off, 9.9);
  EXPECT_LT(off, 14.0);
  EXPECT_GT(called("limp 17", 7.0), 0.0);
  EXPECT_LE(called("limp 17", 7.0), off) << "gains go before the power";
  EXPECT_GE(called("shut down"), off);
}

TEST_F(Story, APauseThatTakesThePowerAlsoSwitchesTheRobotOff) {
  press(2.0, 0.3);
  say(7.0, orsbPAUSE);
  at(7.0, [this] { system_->jam(); });
  play(15.0);
  EXPECT_EQ(called("power on", 7.0), -1.0);
  EXPECT_EQ(called("hold 0", 7.0), -1.0);
  EXPECT_GT(called("shut down"), 9.9);
}

TEST_F(Story, AnEmptyBatteryLiesDownFirstAndSwitchesTheRobotOffThen) {
  press(2.0, 0.3);
  say(7.0, orsbBATTERY_CAPACITY_LOW);
  play(16.0);
  EXPECT_NEAR(restedFrom(Rest::batteryLow), 7.0, 0.07);
  const double off = called("power off", 7.0);
  ASSERT_GT(off, 8.0) << "it lies down first";
  EXPECT_GE(called("shut down"), off);
  EXPECT_LE(fastest(desk_, 7.0 + kInFlight, off), kGentle);
}

TEST_F(Story, ABatteryThatIsEmptyFromTheStartNeverRaisesTheRobot) {
  say(0.0, orsbBATTERY_CAPACITY_LOW);
  press(1.0, 0.3);
  play(4.0);
  EXPECT_EQ(restedFrom(Rest::none), -1.0);
  EXPECT_GE(called("shut down"), 0.0);
  EXPECT_EQ(fastest(desk_, 0.0, 4.0), 0.0);
}

struct Cause {
  const char* name;
  longword bits;
  Rest rest;
};

class StoryOf : public Story, public testing::WithParamInterface<Cause> {};

TEST_P(StoryOf, AFaultOfTheBodyEndsWithoutPowerAndBeginsAnewOnlyWhenItIsOverAndThePersonAsks) {
  press(2.0, 0.3);
  say(7.0, GetParam().bits);
  press(16.0, 0.3);  // too early: it is not over
  say(20.0, 0);
  press(60.0, 0.3);
  play(66.0);
  EXPECT_NEAR(restedFrom(GetParam().rest), 7.0, 0.07);
  const double off = called("power off", 7.0);
  ASSERT_GT(off, 8.0);
  EXPECT_LT(off, 14.0);
  EXPECT_EQ(called("shut down"), -1.0) << "Sony's objects do not end the system for it";
  EXPECT_GE(called("power on", off), 60.0);
  EXPECT_EQ(rests.back().rest, Rest::none);
}

INSTANTIATE_TEST_SUITE_P(Causes, StoryOf,
                         testing::Values(Cause{"OverCurrent", orsbBATTERY_OVER_CURRENT,
                                               Rest::overCurrent},
                                         Cause{"Hot", orsbBATTERY_OVER_TEMP_DISCHARGING, Rest::hot},
                                         Cause{"Fan", orsbERROR_OF_FAN, Rest::fan}),
                         [](const auto& cause) { return std::string(cause.param.name); });

TEST_F(Story, LiftedOffTheGroundItGoesSlackAtOnceAndGoesOnWhenItHasBeenPutDownAndIsStill) {
  press(2.0, 0.3);
  at(7.0, [this] { desk_.lifted = true; });
  at(11.5, [this] {
    desk_.lifted = false;
    desk_.frame.joints[Joint::leftFrontRotator] = Angle::deg(80.0);  // as it was put down
  });
  play(17.0);
  const double slack = called("limp 4", 7.0);
  ASSERT_GT(slack, 0.0);
  EXPECT_LE(slack, 7.5);
  const double again = called("hold 0", slack);
  EXPECT_GE(again, 12.5) << "a second still";
  expectGainsInTurn(slack, 17.0);
  EXPECT_EQ(rests.back().rest, Rest::none);
  EXPECT_LE(fastest(desk_, again, restedFrom(Rest::none, again) + 1.0), kGentle);
}

TEST_F(Story, AJointThatDoesNotFollowEndsWithoutPower) {
  press(2.0, 0.3);
  at(7.0, [this] {
    desk_.blocked = 1U << index(Joint::leftFrontKnee);
    desk_.frame.joints[Joint::leftFrontKnee] = Angle::deg(-20.0);
  });
  play(20.0);
  EXPECT_NEAR(restedFrom(Rest::jointStuck), 9.0, 0.3);
  EXPECT_GT(called("power off", 9.0), 0.0);
  EXPECT_LT(called("power off", 9.0), 19.0);
  EXPECT_EQ(called("shut down"), -1.0);
}

TEST_F(Story, WithoutImagesItLiesDownButKeepsItsPower) {
  press(2.0, 0.3);
  at(7.0, [this] { desk_.images = false; });
  at(12.0, [this] { desk_.images = true; });
  play(16.0);
  EXPECT_GT(restedFrom(Rest::blind), 7.9);
  EXPECT_GT(called("power off", 7.0), 15.9) << "with the object's end, not before";
  EXPECT_EQ(rests.back().rest, Rest::none);
  const double blind = restedFrom(Rest::blind) + kInFlight;
  EXPECT_LE(fastest(desk_, blind, restedFrom(Rest::none, 9.0) + 1.0), kGentle);
}

TEST_F(Story, WithoutALightAPawAndAnEarItPlaysAndShowsThatSomethingIsAmiss) {
  broken_ = {"PRM:/r1/c1/c2/c3/lc-LED3:lc", "PRM:/r2/c1/c2/c3/c4-Sensor:24",
             "PRM:/r1/c1/c2/c3/e5-Joint4:15"};
  press(2.0, 0.3);
  play(8.0);
  EXPECT_EQ(rests.back().rest, Rest::none);
  EXPECT_GT(readyAt, 2.0);
  EXPECT_NE(desk_.leds & body::kLightLacks, 0U);
}

class StoryWithout : public Story, public testing::WithParamInterface<const char*> {};

TEST_P(StoryWithout, AVitalPartItNeverHasPowerAndBlinks) {
  broken_ = {GetParam()};
  press(2.0, 0.3);
  play(6.0);
  EXPECT_EQ(called("power on"), -1.0);
  EXPECT_EQ(heldInTurn(0.0, 6.0).size(), 0U);
  const std::uint32_t face = ((1U << body::kFaceLights) - 1U) << body::kFirstFaceLight;
  EXPECT_EQ(desk_.leds & face, face) << "fault 14";
}

INSTANTIATE_TEST_SUITE_P(Parts, StoryWithout,
                         testing::Values("PRM:/r3/c1-Joint2:31",
                                         "PRM:/r1/c1/c2/c3/i1-FbkImageSensor:F1"));

TEST_F(Story, TheEndOfTheObjectLeavesNoJointHeldAndNoPower) {
  press(2.0, 0.3);
  play(8.0);
  EXPECT_EQ(system_->calls.back().what, "power off");
  EXPECT_EQ((system_->calls.end() - 2)->what, "limp all");
}

}  // namespace
}  // namespace kelpie::agent
