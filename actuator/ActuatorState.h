// SPDX-License-Identifier: Apache-2.0
// What the actuator remembers between messages. Plain data; ActuatorState{} is the robot just
// switched on.
#pragma once

#include <array>
#include <cstdint>

#include "robot/core/Geometry.h"
#include "robot/core/Motion.h"

namespace kelpie::actuator {

// Speed of the robot frame over the ground.
struct Velocity {
  double forward = 0.0;  // cm/s
  double left = 0.0;     // cm/s
  double turn = 0.0;     // rad/s
};

struct Foot {
  Point3<Robot> position;
  Point2<Robot> liftedAt;  // where the running swing began
};

struct GaitState {
  Velocity velocity;  // slewed and scaled: what is walked now
  std::array<Foot, kLegCount> feet{};
  std::uint32_t tick = 0;  // in the double half step
  bool placed = false;     // feet have been put to their homes
  bool standing = true;
};

struct MotionState {
  MotionKind kind = MotionKind::none;
  std::uint32_t tick = 0;
  bool answered = false;  // the request that started it still stands: do not start again
};

constexpr std::size_t kMaxDelay = 24;  // ticks of odometry kept back

// Duty of the hardest working leg joint in each tick of walking without a break.
struct EffortState {
  std::array<double, 128> duty{};  // a ring; a step has at most 120 ticks
  std::uint32_t ticks = 0;         // walked, all in all
};

struct GainState {
  bool low = false;
  double current = 0.0;  // mA, running mean
};

struct ActuatorState {
  bool started = false;
  std::uint32_t rampTick = 0;
  JointAngles rampFrom;
  JointAngles target;  // last commanded
  GaitState gait;
  MotionState motion;
  EffortState effort;
  GainState gain;
  std::array<Velocity, kMaxDelay + 1> walked{};  // ring of the last ticks
  std::uint32_t walkedNext = 0;
};

}  // namespace kelpie::actuator
