// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <limits>

#include "actuator/feeling/HeldBall.h"

namespace kelpie::actuator {
namespace {

// The head that holds, the neck so far below where it shall be, the chest's sensor.
class Holds : public ::testing::Test {
 protected:
  Holds() {
    commanded[Joint::neckTilt] = Angle::deg(-52.0);
    commanded[Joint::mouth] = Angle::deg(-55.0);
    feel(4.4, 10.0, false);
  }
  void feel(double sag, double chest, bool chin) {
    for (SensorFrame& tick : in.sensors) {
      tick.joints[Joint::neckTilt] = Angle::deg(-52.0 - sag);
      tick.chestDistance = chest;
      tick.chin = chin;
    }
  }
  bool run(int messages) {
    bool held = false;
    for (int i = 0; i < messages; ++i) held = stepHeldBall(in, commanded, params, state);
    return held;
  }

  MotionInput in;
  JointAngles commanded;
  HeldBallParams params;
  HeldBallState state;
};

TEST_F(Holds, AnEmptyHeadSagsAndHoldsNothing) { EXPECT_FALSE(run(20)); }

TEST_F(Holds, OneTouchOfTheChinCountsForASixthOfASecond) {
  run(10);
  feel(4.4, 10.0, true);
  EXPECT_TRUE(run(1));
  feel(4.4, 10.0, false);
  EXPECT_TRUE(run(4));
  EXPECT_FALSE(run(1));
}

TEST_F(Holds, ANeckThatDoesNotSagIsPropped) {
  run(10);
  feel(1.5, 10.0, false);
  EXPECT_TRUE(run(7));
}

TEST_F(Holds, AChestSensorThatFoldsBackHasTheBallBeforeIt) {
  run(10);
  feel(4.4, 25.0, false);
  EXPECT_TRUE(run(7));
}

TEST_F(Holds, AHeadThatIsUpOrAShutJawHoldsNothing) {
  feel(0.0, 25.0, true);
  EXPECT_TRUE(run(10));
  commanded[Joint::mouth] = Angle::deg(-3.0);
  EXPECT_FALSE(run(10));
  commanded[Joint::mouth] = Angle::deg(-55.0);
  commanded[Joint::neckTilt] = Angle::deg(-20.0);
  EXPECT_FALSE(run(10));
}

TEST_F(Holds, SaysNoUntilTheWindowIsFull) {
  feel(0.0, 25.0, true);
  EXPECT_FALSE(run(4));
  EXPECT_TRUE(run(1));
}

TEST_F(Holds, WhatIsNotFiniteIsNoBall) {
  feel(std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(), false);
  for (SensorFrame& tick : in.sensors)
    tick.joints[Joint::neckTilt] = Angle::rad(std::numeric_limits<double>::quiet_NaN());
  EXPECT_FALSE(run(20));
}

}  // namespace
}  // namespace kelpie::actuator
