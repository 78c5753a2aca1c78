// SPDX-License-Identifier: Apache-2.0
// What an attacker found between switching on and switching off: causes that come one upon the
// other, power that goes and comes at the wrong moment, hands, and a system that refuses.
#include "robot/agent/loops/FaultLoops.h"
#include "tests/agent/Story.h"

namespace kelpie::agent {
namespace {

constexpr longword kHot = orsbBATTERY_OVER_TEMP_DISCHARGING;
constexpr const char* kCamera = "PRM:/r1/c1/c2/c3/i1-FbkImageSensor:F1";

class SafetyStory : public Story {
 protected:
  void block(double from) {
    at(from, [this] {
      desk_.blocked = 1U << index(Joint::leftFrontKnee);
      desk_.frame.joints[Joint::leftFrontKnee] = Angle::deg(-20.0);
    });
  }
  void cut(double when) {
    at(when, [this] {
      system_->jam();
      desk_.frame.joints[Joint::leftHindKnee] = Angle::deg(110.0);
      desk_.frame.joints[Joint::leftFrontShoulder] = Angle();
    });
  }
  void giveBack(double when) {
    at(when, [this] { system_->giveBack(); });
  }
  void lift(double when, bool lifted = true) {
    at(when, [this, lifted] { desk_.lifted = lifted; });
  }
  double slackAfter(double when) const { return called("limp 4", when); }
};

// A robot that has ended for one cause, and what must still switch it off.
struct Pair {
  const char* name;
  longword first;  // 0: a joint does not follow
  longword then;
};
class AfterAnEnd : public SafetyStory, public testing::WithParamInterface<Pair> {};

TEST_P(AfterAnEnd, APauseThatIsHeldAndAnEmptyBatteryStillSwitchOff) {
  press(2.0, 0.3);
  if (GetParam().first == 0) block(7.0);
  say(7.0, GetParam().first);
  say(20.0, GetParam().first | GetParam().then);
  play(25.0);
  EXPECT_GT(called("power off", 7.0), 0.0);
  EXPECT_LT(called("power off", 7.0), 17.0);
  EXPECT_GE(called("shut down"), 20.0);
}

INSTANTIATE_TEST_SUITE_P(Pairs, AfterAnEnd,
                         testing::Values(Pair{"HotPause", kHot, orsbPAUSE},
                                         Pair{"HotLow", kHot, orsbBATTERY_CAPACITY_LOW},
                                         Pair{"FanLow", orsbERROR_OF_FAN, orsbBATTERY_CAPACITY_LOW},
                                         Pair{"StuckPause", 0, orsbPAUSE},
                                         Pair{"StuckLow", 0, orsbBATTERY_CAPACITY_LOW}),
                         [](const auto& pair) { return std::string(pair.param.name); });

// A robot that cannot play is switched off like any other.
class WithoutPlay : public SafetyStory, public testing::WithParamInterface<longword> {};

TEST_P(WithoutPlay, ARefusedStickLeavesThePauseAndTheBatteryTheirEffect) {
  say(3.0, GetParam());
  FaultLoops loops;
  loops.setFault(1);
  play(7.0, loops);
  EXPECT_GE(called("shut down"), 3.0);
  EXPECT_EQ(called("power on"), -1.0);
}

TEST_P(WithoutPlay, ALackingCameraLeavesThePauseAndTheBatteryTheirEffect) {
  broken_ = {kCamera};
  say(3.0, GetParam());
  play(7.0);
  EXPECT_GE(called("shut down"), 3.0);
  EXPECT_EQ(called("power on"), -1.0);
}

INSTANTIATE_TEST_SUITE_P(Bits, WithoutPlay, testing::Values(orsbPAUSE, orsbBATTERY_CAPACITY_LOW));

TEST_F(SafetyStory, AShortPauseWithoutAStickSwitchesNothingOff) {
  say(3.0, orsbPAUSE);
  say(5.8, 0);
  FaultLoops loops;
  play(12.0, loops);
  EXPECT_EQ(called("shut down"), -1.0);
}

TEST_F(SafetyStory, APauseBelowThreeSecondsAndManyShortOnesSwitchNothingOff) {
  press(2.0, 0.3);
  say(7.0, orsbPAUSE);
  say(9.8, 0);
  at(13.0, [this] { desk_.images = false; });
  for (int i = 0; i < 6; ++i) {
    say(16.0 + 0.9 * i, orsbPAUSE);
    say(16.2 + 0.9 * i, 0);
  }
  play(24.0);
  EXPECT_EQ(called("shut down"), -1.0);
}

// Power that comes back while it lies: as after any cut.
TEST_F(SafetyStory, PowerThatComesBackWhileItLiesHoldsOneJointAfterTheOther) {
  press(2.0, 0.3);
  at(7.0, [this] { desk_.images = false; });
  cut(12.0);
  giveBack(13.0);
  at(16.0, [this] { desk_.images = true; });
  play(22.0);
  expectGainsInTurn(12.0, 22.0);
  EXPECT_GT(called("hold 0", 12.0), 13.0);
  EXPECT_EQ(rests.back().rest, Rest::none);
  EXPECT_LE(fastestHeld, kGentle);
}

TEST_F(SafetyStory, APauseThatTakesThePowerAndGivesItBackHoldsOneJointAfterTheOther) {
  press(2.0, 0.3);
  say(7.0, orsbPAUSE);
  cut(7.5);
  giveBack(8.0);
  say(8.2, 0);
  play(16.0);
  expectGainsInTurn(7.5, 16.0);
  EXPECT_EQ(rests.back().rest, Rest::none);
  EXPECT_LE(fastestHeld, kGentle);
}

TEST_F(SafetyStory, ACutThatIsOverBeforeTheNextMessageBeginsAnewToo) {
  press(2.0, 0.3);
  at(7.0, [this] {
    system_->dip();
    desk_.frame.joints[Joint::leftHindKnee] = Angle::deg(110.0);
  });
  play(14.0);
  expectGainsInTurn(6.9, 14.0);
  EXPECT_EQ(rests.back().rest, Rest::none);
  EXPECT_LE(fastestHeld, kGentle);
}

TEST_F(SafetyStory, ShakenWhileItStandsUpItIsSlackWithinHalfASecond) {
  press(2.0, 0.3);
  lift(2.8);
  play(6.0);
  ASSERT_GT(slackAfter(2.8), 0.0);
  EXPECT_LE(slackAfter(2.8), 3.3);
}

TEST_F(SafetyStory, CarriedOffWhileItLiesItIsSlackWithinHalfASecond) {
  press(2.0, 0.3);
  at(7.0, [this] { desk_.images = false; });
  lift(12.0);
  play(14.0);
  ASSERT_GT(slackAfter(12.0), 0.0);
  EXPECT_LE(slackAfter(12.0), 12.5);
}

// Turned over in one movement it thinks that it has fallen.
TEST_F(SafetyStory, WhatGetsUpInSomebodysHandsIsSlackAfterASecondOfIt) {
  press(2.0, 0.3);
  at(7.0, [this] {
    desk_.pawsFail = true;
    desk_.frame.acceleration = {0.0, -981.0, 0.0};
  });
  play(14.0);
  ASSERT_GT(slackAfter(7.0), 0.0);
  EXPECT_LE(slackAfter(7.0), 9.0);
  EXPECT_EQ(called("hold 0", slackAfter(7.0)), -1.0);
}

TEST_F(SafetyStory, HeldStillOnItsSideItStaysSlack) {
  press(2.0, 0.3);
  lift(7.0);
  at(7.4, [this] {
    desk_.lifted = false;
    desk_.pawsFail = true;
    desk_.frame.acceleration = {0.0, -900.0, -300.0};
  });
  play(16.0);
  ASSERT_GT(slackAfter(7.0), 0.0);
  EXPECT_LE(slackAfter(7.0), 7.5);
  EXPECT_EQ(called("hold 0", slackAfter(7.0)), -1.0);
}

TEST_F(SafetyStory, PawsThatFailCollapseNobodyWhoIsNotMoved) {
  press(2.0, 0.3);
  at(7.0, [this] { desk_.pawsFail = true; });
  play(14.0);
  EXPECT_EQ(restedFrom(Rest::lifted), -1.0);
}

TEST_F(SafetyStory, AShortPressIsEnoughWherePowerComesLate) {
  press(2.0, 0.3);
  at(7.0, [this] {
    system_->jam();
    system_->late = true;
  });
  press(9.0, 0.3);
  giveBack(9.8);
  play(14.0);
  EXPECT_EQ(calledOften("power on", 7.0, 13.9), 1U);
  EXPECT_EQ(rests.back().rest, Rest::none);
}

TEST_F(SafetyStory, PowerThatDoesNotComeIsAskedForForTwoSecondsAndTheLightsSaySo) {
  press(2.0, 0.3);
  at(7.0, [this] {
    system_->jam();
    system_->late = true;
  });
  press(9.0, 0.3);
  play(13.0);
  EXPECT_NEAR(called("power off", 9.0), 11.0, 0.1);
  EXPECT_TRUE(shows(Rest::powerless));
}

TEST_F(SafetyStory, AHandThatStaysOnTheHeadFightsNoJam) {
  press(2.0, 0.3);
  press(6.9, 100.0);
  for (int i = 0; i < 20; ++i) at(7.0 + 0.2 * i, [this] { system_->jam(); });
  play(13.0);
  EXPECT_EQ(calledOften("power on", 6.5, 12.9), 0U);
}

TEST_F(SafetyStory, AHandThatStaysOnTheHeadRaisesNoRobotThatHasCooled) {
  press(2.0, 0.3);
  press(6.5, 100.0);
  say(7.0, kHot);
  say(20.0, 0);
  play(56.0);
  EXPECT_EQ(called("power on", 6.0), -1.0);
}

TEST_F(SafetyStory, ARobotInSomebodysHandsAsksForNoPowerAfterAJam) {
  press(2.0, 0.3);
  lift(7.0);
  at(9.0, [this] { system_->jam(); });
  lift(10.0, false);
  play(14.0);
  EXPECT_EQ(called("power on", 6.9), -1.0);
  EXPECT_TRUE(shows(Rest::powerless));
}

TEST_F(SafetyStory, AShortPauseEndsNoFault) {
  press(2.0, 0.3);
  say(7.0, orsbBATTERY_OVER_CURRENT);
  say(7.1, orsbPAUSE);
  say(7.3, 0);
  play(20.0);
  EXPECT_EQ(restedFrom(Rest::none, 7.0), -1.0);
  EXPECT_GT(called("power off", 7.0), 0.0);
}

TEST_F(SafetyStory, ABatteryThatWasLowForAMomentSwitchesOffThoughAPauseCame) {
  press(2.0, 0.3);
  say(7.0, orsbBATTERY_CAPACITY_LOW);
  say(7.2, orsbPAUSE);
  say(7.4, 0);
  play(20.0);
  EXPECT_GT(called("shut down"), 7.0);
}

TEST_F(SafetyStory, TheHeadThatScansKeepsNoRobotFromStanding) {
  desk_.frame.joints[Joint::headPan] = Angle::deg(-88.0);
  desk_.frame.joints[Joint::neckTilt] = Angle::deg(-75.0);
  desk_.frame.joints[Joint::headNod] = Angle::deg(45.0);
  press(2.0, 0.3);
  play(8.0);
  ASSERT_GT(readyAt, 2.0);
  EXPECT_LT(readyAt, 5.5);
}

TEST_F(SafetyStory, ACameraThatIsSilentFromTheStartIsShown) {
  desk_.images = false;
  press(2.0, 0.3);
  play(5.0);
  EXPECT_TRUE(shows(Rest::blind));
}

TEST_F(SafetyStory, APauseOfARobotThatWaitsIsShown) {
  say(2.0, orsbPAUSE);
  play(4.0);
  EXPECT_EQ(rests.back().rest, Rest::unasked) << "it stays as it was found";
  EXPECT_TRUE(shows(Rest::paused));
}

TEST_F(SafetyStory, AJointThatTakesNoGainIsShownAndTheOthersAreLetGo) {
  befallen_ = [](FaultySystem& system) { system.refused = 5; };
  press(2.0, 0.3);
  play(6.0);
  EXPECT_TRUE(shows(Rest::jointStuck));
  EXPECT_GT(called("power off"), 0.0);
  EXPECT_LT(called("power off"), 4.0);
  EXPECT_EQ(messages.back().held, 0U);
}

TEST_F(SafetyStory, AnEndThatIsRefusedIsAskedForAgain) {
  befallen_ = [](FaultySystem& system) { system.refusals = 3; };
  say(2.0, orsbBATTERY_CAPACITY_LOW);
  play(9.0);
  EXPECT_NEAR(called("shut down"), 5.1, 0.2) << "each second";
}

TEST_F(SafetyStory, APressThatAsksForPowerTellsNothingOfTheGame) {
  press(2.0, 0.3);  // ready
  press(6.0, 0.3);  // set
  at(7.0, [this] { system_->jam(); });
  press(9.0, 0.3);
  play(14.0);
  EXPECT_EQ(leds & (body::kLightRed | body::kLightGreen | body::kLightBlue),
            body::lightsOf(PlayState::set, false));
  EXPECT_EQ(rests.back().rest, Rest::none);
}

}  // namespace
}  // namespace kelpie::agent
