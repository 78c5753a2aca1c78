// SPDX-License-Identifier: Apache-2.0
// The gain of a motion's key frames gets to the servos of both bodies, and ends with the motion.
#include <gtest/gtest.h>

#include <cmath>

#include "tools/learn/kick/KickLearner.h"
#include "tools/learn/motion/MotionPlay.h"
#include "tools/learn/walk/WalkLearner.h"
#include "tools/sim/bodies/WalkingBody.h"

namespace kelpie::learn {
namespace {

using actuator::MotionData;

MotionData withGain(MotionData motion, double gain) {
  for (actuator::KeyFrame& key : motion.frames) key.gain = gain;
  return motion;
}

double farthestLeg(const JointAngles& a, const JointAngles& b) {
  double far = 0.0;
  for (std::size_t j = index(Joint::leftFrontRotator); j <= index(Joint::rightHindKnee); ++j)
    far = std::fmax(far, std::fabs((a.angle[j] - b.angle[j]).deg()));
  return far;
}

// How far the robot's weight pushes its legs away from where they shall stay, deg.
double sag(double gain) {
  actuator::KeyFrame key;
  key.ticks = 120;
  key.gain = gain;
  actuator::MotionData motion;
  motion.frames.push_back(key);
  MotionStage stage = standingStage(MotionKind::sit, motion, {}, 3);
  for (int i = 0; i < 25; ++i) stage.walker->step(stage.command);
  return farthestLeg(stage.walker->place().joints, stage.walker->output().joints[0].target);
}

TEST(MotionGain, SoftLegsGiveWayToTheWeight) { EXPECT_GT(sag(0.4), 1.5 * sag(1.0)); }

// cm, the mean.
double kicked(double gain) {
  const MotionKind kind = MotionKind::wedge;  // the hard kick falls more than it pushes
  const MotionData& motion = actuator::standardMotions()[kind];
  const KickAim aim = aimOf(*findKick(kind), motion);
  const auto starts = beforeKicks(aim, variedModels(31, 2, 0.002), 2, 31);
  return spreadOf(tryFromAll(withGain(motion, gain), aim, starts)).distance;
}

TEST(MotionGain, SoftLegsThrowAHeldBallLessFar) { EXPECT_LT(kicked(0.4), 0.7 * kicked(1.0)); }

// Where the joints are while the robot sits down, and long after it has got up.
struct Joints {
  JointAngles during;
  JointAngles after;
};

Joints sitting(sim::BodyKind body, double gain) {
  constexpr int kHalfDown = 12;  // messages
  constexpr int kUp = 120;
  actuator::ActuatorParams params;
  params.motions[MotionKind::sit] = withGain(params.motions[MotionKind::sit], gain);
  sim::WalkingBody robot(7, params, body);
  Command command;
  command.motion = MotionKind::sit;
  Joints joints;
  for (int i = 0; i < kUp; ++i) {
    robot.step(command);
    joints.after = robot.world().sensors(0).back().joints;
    if (i == kHalfDown) joints.during = joints.after;
  }
  return joints;
}

TEST(MotionGain, LegsOfBothBodiesAreSoftUntilTheMotionEnds) {
  for (const sim::BodyKind body : {sim::BodyKind::fast, sim::BodyKind::physical}) {
    const Joints full = sitting(body, 1.0);
    const Joints soft = sitting(body, 0.4);
    EXPECT_GT(farthestLeg(full.during, soft.during), 3.0);
    EXPECT_LT(farthestLeg(full.after, soft.after), 1.0);
  }
}

}  // namespace
}  // namespace kelpie::learn
