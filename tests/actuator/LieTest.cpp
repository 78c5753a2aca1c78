// SPDX-License-Identifier: Apache-2.0
// What is commanded of the legs while the robot rests (tests/learn/LieTest.cpp plays it).
#include <gtest/gtest.h>

#include <cmath>

#include "tests/actuator/Walker.h"

namespace kelpie::actuator {
namespace {

const JointAngles& last(const Walker& walker) { return walker.out.joints.back().target; }

double furthest(const JointAngles& a, const JointAngles& b) {
  double max = 0.0;
  for (std::size_t j = 0; j < index(Joint::tailTilt); ++j)
    max = std::fmax(max, std::fabs((a.angle[j] - b.angle[j]).deg()));
  return max;
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
  run(walker, Command{}, Rest::none, 100);
  JointAngles before = last(walker);
  for (const Rest rest : {Rest::paused, Rest::none}) {
    walker.input.rest = rest;
    for (int i = 0; i < 100; ++i) {
      walker.run(Command{}, 1);
      for (const JointFrame& frame : walker.out.joints) {
        EXPECT_LE(furthest(frame.target, before), 60.0 * 0.008 + 1e-9);
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
  run(rested, Command{}, Rest::none, 100);
  run(rested, Command{}, Rest::paused, 100);
  run(rested, Command{}, Rest::none, 100);
  run(stood, Command{}, Rest::none, 180);
  EXPECT_LT(furthest(last(rested), last(stood)), 1e-6);
}

TEST(Lie, TellsWhenItHasLainDown) {
  Walker walker;
  run(walker, Command{}, Rest::none, 100);
  EXPECT_FALSE(walker.out.status.lying);
  run(walker, Command{}, Rest::hot, 5);
  EXPECT_FALSE(walker.out.status.lying) << "on the way down";
  run(walker, Command{}, Rest::hot, 95);
  EXPECT_TRUE(walker.out.status.lying);
}

// A joint with a gain stays where it was commanded to be, one without follows what is sensed.
TEST(AsFound, JointsThatAreNotHeldAreCommandedToWhereTheyAre) {
  Walker walker;
  run(walker, Command{}, Rest::none, 100);
  const JointAngles stood = last(walker);
  JointAngles limp = stood;
  for (Angle& angle : limp.angle) angle = Angle::rad(angle.rad() + 0.3);
  for (SensorFrame& sensors : walker.input.sensors) sensors.joints = limp;
  walker.input.rest = Rest::starting;
  walker.input.held = 1U << index(Joint::headPan);
  const MotionOutput out = step(walker.input, walker.params, walker.state);
  for (std::size_t j = 0; j < kJointCount; ++j) {
    const JointAngles& expected = j == index(Joint::headPan) ? stood : limp;
    EXPECT_EQ(out.joints.back().target.angle[j].rad(), expected.angle[j].rad()) << j;
  }
  EXPECT_FALSE(out.status.ready);
}

TEST(AsFound, TheWayUpBeginsWhereItIsHeldAndNoFasterThanAPersonsHand) {
  Walker walker;
  for (SensorFrame& sensors : walker.input.sensors)
    sensors.joints[Joint::leftHindKnee] = Angle::deg(110.0);
  walker.input.held = 0;
  run(walker, walking(), Rest::powerless, 3);
  JointAngles before = last(walker);
  EXPECT_NEAR(before[Joint::leftHindKnee].deg(), 110.0, 1e-9);
  walker.input.held = kAllJoints;
  walker.ticks.clear();
  run(walker, walking(), Rest::none, 20);
  for (const JointAngles& target : walker.ticks) {
    ASSERT_LE(furthest(target, before), 60.0 * 0.008 + 1e-9);
    before = target;
  }
}

}  // namespace
}  // namespace kelpie::actuator
