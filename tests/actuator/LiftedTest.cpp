// SPDX-License-Identifier: Apache-2.0
// When a robot is felt to be lifted and to stand again, by its paws and accelerometer.
#include <gtest/gtest.h>

#include "actuator/Lifted.h"

namespace kelpie::actuator {
namespace {

constexpr double kMessage = 0.032;  // s

class Lifted : public testing::Test {
 protected:
  // For so long, with some paw pressed or none, shaken by so much to and fro.
  void feel(double seconds, bool paw, bool stands = true, double shaken = 0.0) {
    for (double t = 0.0; t < seconds - 1e-9; t += kMessage) {
      sign_ = -sign_;
      MotionInput in;
      for (SensorFrame& tick : in.sensors) {
        tick.acceleration = {sign_ * shaken, 0.0, 981.0};
        tick.paw[2] = paw;
      }
      stepLifted(in, stands, LiftParams{}, state_);
    }
  }
  bool lifted() const { return state_.lifted; }
  LiftState state_;
  double sign_ = 1.0;
};

TEST_F(Lifted, AStepInWhichNoPawTouchesIsNone) {
  feel(1.0, true);
  feel(0.19, false);
  EXPECT_FALSE(lifted());
  feel(0.032, true);
  feel(0.19, false);
  EXPECT_FALSE(lifted());
}

TEST_F(Lifted, FourFreePawsOfARobotThatStandsAreLiftedWithinHalfASecond) {
  feel(1.0, true);
  feel(0.4, false);
  EXPECT_TRUE(lifted());
}

TEST_F(Lifted, WhoLiesOrKicksHasFreePawsInAnyCase) {
  feel(1.0, true);
  feel(5.0, false, false);
  EXPECT_FALSE(lifted());
}

TEST_F(Lifted, SwitchesThatNeverCloseTellNothing) {
  feel(60.0, false);
  EXPECT_FALSE(lifted());
}

TEST_F(Lifted, ItStandsAgainWhenAPawIsPressedAndItHasBeenStillForASecond) {
  feel(1.0, true);
  feel(0.5, false);
  feel(2.0, false, false, 200.0);
  feel(0.9, true, false, 200.0);
  EXPECT_TRUE(lifted()) << "a hand still moves it";
  feel(0.8, true, false);
  EXPECT_TRUE(lifted());
  feel(0.6, true, false);
  EXPECT_FALSE(lifted());
}

TEST_F(Lifted, OnItsBellyItStandsAgainAfterSomeSecondsWithoutAPaw) {
  feel(1.0, true);
  feel(3.0, false, false, 200.0);
  feel(0.5, false);
  feel(3.0, false, false);
  EXPECT_TRUE(lifted());
  feel(2.0, false, false);
  EXPECT_FALSE(lifted());
}

}  // namespace
}  // namespace kelpie::actuator
