// SPDX-License-Identifier: Apache-2.0
#include "actuator/motion/MotionPlayer.h"

namespace kelpie::actuator {
namespace {

bool isLeg(std::size_t joint) {
  return joint >= index(Joint::leftFrontRotator) && joint <= index(Joint::rightHindKnee);
}

bool moves(const KeyFrame& key, std::size_t joint) {
  if (joint == index(Joint::headPan) && key.asksPan) return false;
  if (joint < 3) return key.movesHead;
  if (joint == index(Joint::mouth)) return key.movesMouth;
  return isLeg(joint) && (key.legs == KeyLegs::angles || key.legs == KeyLegs::stay);
}

Angle aimOf(const KeyFrame& key, std::size_t joint, const JointAngles& from) {
  if (joint < 3) return key.head[joint];
  if (joint == index(Joint::mouth)) return key.mouth;
  if (key.legs == KeyLegs::stay) return from.angle[joint];
  return key.angles[joint - index(Joint::leftFrontRotator)];
}

}  // namespace

std::uint32_t ticksOf(const MotionData& motion) {
  std::uint32_t ticks = 0;
  for (const KeyFrame& key : motion.frames) ticks += key.ticks;
  return ticks;
}

void begin(MotionKind kind, const JointAngles& now, MotionState& state) {
  state = {kind, 0, 0, 0, now, true};
}

const KeyFrame& keyFrame(const Motions& motions, const MotionState& state) {
  return motions[state.kind].frames[state.frame];
}

bool hurried(const Motions& motions, MotionKind asked, const MotionState& state) {
  return running(state) && asked != MotionKind::none && motions[state.kind].hurriedBy == asked;
}

double legGain(const Motions& motions, const MotionState& state) {
  return running(state) ? keyFrame(motions, state).gain : 1.0;
}

JointAngles played(const Motions& motions, const JointAngles& asked, const MotionState& state) {
  const KeyFrame& key = keyFrame(motions, state);
  const double share = key.interpolate ? (state.frameTick + 1.0) / key.ticks : 1.0;
  // A stance is approached as angles are; a walk is not, it has its own smoothness.
  const bool stance = key.legs == KeyLegs::stance;
  JointAngles target = asked;
  for (std::size_t j = 0; j < kJointCount; ++j) {
    const bool mine = moves(key, j);
    if (!mine && !(stance && isLeg(j))) continue;
    const Angle aim = mine ? aimOf(key, j, state.from) : asked.angle[j];
    target.angle[j] = partWay(state.from.angle[j], aim, share);
  }
  return target;
}

bool advance(const Motions& motions, const JointAngles& now, MotionState& state) {
  ++state.tick;
  if (++state.frameTick < keyFrame(motions, state).ticks) return true;
  state.frameTick = 0;
  state.from = now;
  return ++state.frame < motions[state.kind].frames.size();
}

}  // namespace kelpie::actuator
