// SPDX-License-Identifier: Apache-2.0
// When a robot is felt to be lifted and to stand again, by its paws and accelerometer.
#include <gtest/gtest.h>

#include "actuator/feeling/Lifted.h"

namespace kelpie::actuator {
namespace {

constexpr double kMessage = 0.032;  // s

class Lifted : public testing::Test {
 protected:
  // For so long, with some paw pressed or none, shaken by so much to and fro.
  void feel(double seconds, bool paw, double shaken = 0.0, Footing footing = Footing::stands) {
    for (double t = 0.0; t < seconds - 1e-9; t += kMessage) {
      sign_ = -sign_;
      MotionInput in;
      for (SensorFrame& tick : in.sensors) {
        tick.acceleration = upright_ ? std::array<double, 3>{sign_ * shaken, 0.0, 981.0}
                                     : std::array<double, 3>{sign_ * shaken, -900.0, -300.0};
        tick.paw[2] = paw;
      }
      stepLifted(in, footing, LiftParams{}, state_);
    }
  }
  void carry(double seconds) { feel(seconds, false, 200.0, Footing::other); }
  bool lifted() const { return state_.lifted; }
  LiftState state_;
  bool upright_ = true;
  double sign_ = 1.0;
};

TEST_F(Lifted, AStepInWhichNoPawTouchesIsNone) {
  feel(1.0, true);
  feel(0.19, false, 200.0);
  EXPECT_FALSE(lifted());
  feel(0.032, true);
  feel(0.19, false, 200.0);
  EXPECT_FALSE(lifted());
}

TEST_F(Lifted, FourFreePawsOfARobotThatStandsAndIsMovedAreLiftedWithinHalfASecond) {
  feel(1.0, true);
  feel(0.4, false, 200.0);
  EXPECT_TRUE(lifted());
}

TEST_F(Lifted, NobodyLiftsARobotThatDoesNotMove) {
  feel(1.0, true);
  feel(5.0, false);
  EXPECT_FALSE(lifted()) << "its switches fail";
  feel(0.1, false, 200.0);
  EXPECT_TRUE(lifted());
}

TEST_F(Lifted, OnTheWayUpFreePawsTellNothingBeforeOneWasPressed) {
  feel(1.0, true);
  feel(2.0, false, 200.0, Footing::standsUp);
  EXPECT_FALSE(lifted());
  feel(0.1, true, 200.0, Footing::standsUp);
  feel(0.4, false, 200.0, Footing::standsUp);
  EXPECT_TRUE(lifted());
}

TEST_F(Lifted, WhoGetsUpPressesAPawWithinASecond) {
  feel(1.0, true);
  feel(0.7, false, 200.0, Footing::getsUp);
  EXPECT_FALSE(lifted());
  feel(0.4, false, 200.0, Footing::getsUp);
  EXPECT_TRUE(lifted());
}

TEST_F(Lifted, WhoLiesIsLiftedWhileItIsMovedAndNotByAJolt) {
  feel(1.0, true);
  feel(2.0, false, 200.0, Footing::lies);
  EXPECT_FALSE(lifted()) << "it lies down";
  for (int i = 0; i < 10; ++i) {
    feel(0.1, false, 200.0, Footing::lies);
    feel(1.0, false, 0.0, Footing::lies);
  }
  EXPECT_FALSE(lifted());
  feel(0.5, false, 200.0, Footing::lies);
  EXPECT_TRUE(lifted());
}

TEST_F(Lifted, WhoKicksHasFreePawsInAnyCase) {
  feel(1.0, true);
  carry(5.0);
  EXPECT_FALSE(lifted());
}

TEST_F(Lifted, SwitchesThatNeverCloseTellNothing) {
  feel(60.0, false, 200.0);
  EXPECT_FALSE(lifted());
}

TEST_F(Lifted, ItStandsAgainWhenAPawIsPressedAndItHasBeenStillForASecond) {
  feel(1.0, true);
  feel(0.5, false, 200.0);
  carry(2.0);
  feel(0.9, true, 200.0, Footing::other);
  EXPECT_TRUE(lifted()) << "a hand still moves it";
  feel(0.8, true, 0.0, Footing::other);
  EXPECT_TRUE(lifted());
  feel(0.6, true, 0.0, Footing::other);
  EXPECT_FALSE(lifted());
}

TEST_F(Lifted, OnItsBellyItStandsAgainAfterSomeSecondsWithoutAPaw) {
  feel(1.0, true);
  feel(0.5, false, 200.0);
  feel(3.4, false, 0.0, Footing::other);
  EXPECT_TRUE(lifted());
  feel(2.0, false, 0.0, Footing::other);
  EXPECT_FALSE(lifted());
}

TEST_F(Lifted, OnItsSideItMayBeOnALapAndWaitsForLonger) {
  feel(1.0, true);
  feel(0.5, false, 200.0);
  upright_ = false;
  feel(9.0, false, 0.0, Footing::other);
  EXPECT_TRUE(lifted());
  feel(3.0, false, 0.0, Footing::other);
  EXPECT_FALSE(lifted());
}

TEST_F(Lifted, SwitchesThatFailLetItCollapseTwiceAndNotForEver) {
  feel(1.0, true);
  int times = 0;
  for (int i = 0; i < 10; ++i) {
    feel(0.5, false, 200.0);
    times += lifted() ? 1 : 0;
    feel(6.0, false, 0.0, Footing::other);
  }
  EXPECT_EQ(times, 2);
  feel(0.1, true);
  feel(0.5, false, 200.0);
  EXPECT_TRUE(lifted()) << "one has closed";
}

}  // namespace
}  // namespace kelpie::actuator
