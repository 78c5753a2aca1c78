// SPDX-License-Identifier: Apache-2.0
// What was walked in each tick: from the commanded speed of the feet some ticks ago, as the body
// does it late, and from what the joints of the standing feet say now, by the curves and shares of
// the walk; and how sure that is. A robot that stands does not move, whatever carries it.
#pragma once

#include "actuator/ActuatorParams.h"
#include "actuator/odometry/BodyOscillation.h"
#include "actuator/odometry/FootMotion.h"
#include "actuator/odometry/OdometryTerms.h"
#include "actuator/walk/Feet.h"
#include "robot/core/types/Motion.h"

namespace kelpie::actuator {

constexpr std::size_t kMaxDelay = 24;  // ticks of odometry kept back

// One commanded tick.
struct CommandedTick {
  Velocity real;    // that the commands alone make likely
  Velocity joints;  // share of the feet's motion in each direction; 0 standing and in motions
  OdometryVariance motion;  // of a special motion
  Stride stride;            // standing in motions
  Swing swing;              // of that stride
  LegPower commanded{};     // what the legs were commanded to move
  Felt felt;                // until then
};

struct OdometryState {
  std::array<CommandedTick, kMaxDelay + kTicksPerMessage> ticks{};  // a ring of the last
  std::uint32_t count = 0;
  FootMotionState feet;
  Swing swing;        // that the last tick showed
  double load = 0.0;  // of the walk, over some seconds
  ReachState reach;
  Velocity lately;  // of the feet, commanded
};

// The load of one more message of walking.
void recordLoad(double load, OdometryState& state);

// One more tick of feet that move so, and what the walk until it felt like.
Felt felt(const Velocity& feet, OdometryState& state);

void record(const CommandedTick& tick, OdometryState& state);

// What the body showed in one tick of the last message: what was commanded the delay before it.
const CommandedTick& shown(std::size_t tick, const OdometryParams& params,
                           const OdometryState& state);

// Of the last four ticks.
using SensedPoses = std::array<SensedPose, kTicksPerMessage>;
Odometry odometry(const MotionInput& in, const SensedPoses& poses, const OdometryParams& params,
                  OdometryState& state);

}  // namespace kelpie::actuator
