// SPDX-License-Identifier: Apache-2.0
// What the legs are told while the robot rests (tests/learn/LieTest.cpp plays it).
#include <gtest/gtest.h>

#include <cmath>

#include "tests/actuator/Walker.h"

namespace kelpie::actuator {
namespace {

const JointAngles& last(const Walker& walker) { return walker.out.joints.back().target; }

double furthest(const JointAngles& a, const JointAngles& b) {
  double most = 0.0;
  for (std::size_t j = 0; j < index(Joint::tailTilt); ++j)
    most = std::fmax(most, std::fabs((a.angle[j] - b.angle[j]).deg()));
  return most;
}

void run(Walker& walker, const Command& command, Rest rest, int messages) {
  walker.input.rest = rest;
  walker.run(command, messages);
}

Command walking() {
  Command command;
  command.walk.forward = 20.0;
  return command;
}

TEST(Lie, EndsFlatWhateverIsAskedAndStaysThere) {
  Walker walker;
  run(walker, walking(), Rest::none, 60);
  run(walker, walking(), Rest::batteryLow, 60);
  const JointAngles lies = last(walker);
  EXPECT_NEAR(lies[Joint::leftFrontShoulder].deg(), 85.0, 1e-9);
  EXPECT_NEAR(lies[Joint::rightHindKnee].deg(), 60.0, 1e-9);
  Command kick = walking();
  kick.motion = MotionKind::kickForward;
  run(walker, kick, Rest::batteryLow, 60);
  EXPECT_EQ(furthest(last(walker), lies), 0.0);
}

TEST(Lie, GoesDownAndUpWithoutAJump) {
  Walker walker;
  run(walker, walking(), Rest::none, 60);
  JointAngles before = last(walker);
  for (const Rest rest : {Rest::paused, Rest::none}) {
    walker.input.rest = rest;
    for (int i = 0; i < 60; ++i) {
      walker.run(Command{}, 1);
      for (const JointFrame& frame : walker.out.joints) {
        EXPECT_LE(furthest(frame.target, before), 4.0 + 1e-9);
        before = frame.target;
      }
    }
  }
}

TEST(Lie, BreaksOffAMotionWhichDoesNotGoOnAfterwards) {
  Walker walker;
  run(walker, Command{}, Rest::none, 60);
  Command kick;
  kick.motion = MotionKind::kickForward;
  run(walker, kick, Rest::none, 5);
  ASSERT_EQ(walker.out.status.running, MotionKind::kickForward);
  run(walker, kick, Rest::powerless, 1);
  EXPECT_EQ(walker.out.status.running, MotionKind::none);
}

TEST(Lie, EndsInTheStanceOfARobotThatNeverLay) {
  Walker rested;
  Walker stood;
  run(rested, Command{}, Rest::none, 60);
  run(rested, Command{}, Rest::paused, 60);
  run(rested, Command{}, Rest::none, 60);
  run(stood, Command{}, Rest::none, 180);
  EXPECT_LT(furthest(last(rested), last(stood)), 1e-6);
}

}  // namespace
}  // namespace kelpie::actuator
