// SPDX-License-Identifier: Apache-2.0
// What the actuator remembers between messages. Plain data; ActuatorState{} is the robot just
// switched on.
#pragma once

#include <array>

#include "actuator/feeling/Effort.h"
#include "actuator/feeling/Feeling.h"
#include "actuator/feeling/HeldBall.h"
#include "actuator/motion/Approach.h"
#include "actuator/motion/MotionPlayer.h"
#include "actuator/odometry/Odometry.h"
#include "actuator/walk/Walk.h"

namespace kelpie::actuator {

// From a pose to where the joints are asked to be, in a straight line, after a motion.
struct BlendState {
  JointAngles from;
  std::uint32_t tick = 0;
  std::uint32_t ticks = 0;
};

struct ActuatorState {
  bool started = false;
  bool ready = false;  // it stands: no approach is under way
  bool found = false;  // it stays as it was found
  bool lies = false;   // it rests, or is on its way down
  ApproachState approach;
  BlendState blend;
  JointAngles target;  // last commanded
  Stance stance;       // as last sensed
  WalkState walk;
  MotionState motion;
  double legGain = 1.0;  // the greatest share that the ticks sent last want of the legs' gain
  EffortState effort;
  GainState gain;
  FeelingState feeling;
  HeldBallState heldBall;
  OdometryState odometry;
  std::array<std::uint32_t, 2> earTicks{};  // that each ear has been up
};

}  // namespace kelpie::actuator
