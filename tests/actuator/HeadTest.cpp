// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>

#include "actuator/motion/Head.h"
#include "tests/actuator/Walker.h"

namespace kelpie::actuator {
namespace {

Command looking(double neck, double pan, double nod, double speed = 0.0) {
  Command command;
  command.head.neckTilt = Angle::deg(neck);
  command.head.headPan = Angle::deg(pan);
  command.head.headNod = Angle::deg(nod);
  command.head.speed = speed;
  return command;
}

TEST(Head, ReachesWhatIsAskedFor) {
  Walker w;
  w.standUp();
  w.run(looking(-30, 60, 20), 10);
  EXPECT_NEAR(w.ticks.back()[Joint::neckTilt].deg(), -30, 1e-9);
  EXPECT_NEAR(w.ticks.back()[Joint::headPan].deg(), 60, 1e-9);
  EXPECT_NEAR(w.ticks.back()[Joint::headNod].deg(), 20, 1e-9);
}

TEST(Head, TurnsAtTheRequestedSpeed) {
  Walker w;
  w.standUp();
  w.run(looking(0, 80, 0, 2.0), 5);
  EXPECT_NEAR(w.ticks.back()[Joint::headPan].rad(), 2.0 * 20 * 0.008, 1e-9);
}

TEST(Head, SpeedZeroTurnsByTheSlewLimit) {
  Walker w;
  w.standUp();
  w.run(looking(0, 80, 0), 3);
  EXPECT_NEAR(w.ticks.back()[Joint::headPan].deg(), 12 * 4.0, 1e-9);
}

// Spec openr.md 5.6: neck below -40 deg needs the nod at 5 deg or more, else -5 deg.
TEST(Head, NeverTouchesTheBodyOnAnyWay) {
  Walker w;
  w.standUp();
  for (const auto& goal : {looking(-75, 0, -15), looking(0, 0, -15), looking(-75, 0, -15, 0.5),
                           looking(-20, 0, 45), looking(-60, 80, -15), looking(-10, 0, -15)})
    w.run(goal, 60);
  for (const JointAngles& joints : w.ticks) {
    const double min = joints[Joint::neckTilt].deg() < -40.0 - 1e-6 ? 5.0 : -5.0;
    ASSERT_GE(joints[Joint::headNod].deg(), min - 1e-4);
  }
}

TEST(Head, LowestLookIsReachedWithTheNodAtItsBound) {
  Walker w;
  w.standUp();
  w.run(looking(-75, 0, -15), 30);
  EXPECT_NEAR(w.ticks.back()[Joint::neckTilt].deg(), -75, 1e-9);
  EXPECT_NEAR(w.ticks.back()[Joint::headNod].deg(), 5, 1e-9);
}

TEST(Head, MouthOpensAndCloses) {
  Walker w;
  w.standUp();
  Command command;
  command.mouthOpen = true;
  w.run(command, 10);
  EXPECT_NEAR(w.ticks.back()[Joint::mouth].deg(), -55, 1e-9);
  w.run(Command{}, 10);
  EXPECT_NEAR(w.ticks.back()[Joint::mouth].deg(), -3, 1e-9);
}

}  // namespace
}  // namespace kelpie::actuator
