// SPDX-License-Identifier: Apache-2.0
#include "actuator/feeling/Lifted.h"

#include <algorithm>
#include <cmath>

#include "robot/core/Maths.h"

namespace kelpie::actuator {
namespace {

constexpr double kMessageSeconds = kTickSeconds * kTicksPerMessage;

bool pressed(const SensorFrame& tick) {
  return std::any_of(tick.paw.begin(), tick.paw.end(), [](bool paw) { return paw; });
}

bool anyPressed(const MotionInput& in) {
  return std::any_of(in.sensors.begin(), in.sensors.end(), pressed);
}

// Mean of the message, in which a quarter of the noise's variance is left.
std::array<double, 3> meanOf(const MotionInput& in) {
  std::array<double, 3> mean{};
  for (const SensorFrame& tick : in.sensors)
    for (std::size_t k = 0; k < mean.size(); ++k)
      mean[k] +=
          std::isfinite(tick.acceleration[k]) ? tick.acceleration[k] / kTicksPerMessage : 0.0;
  return mean;
}

// How far it is from what it was recently.
double movement(const MotionInput& in, const LiftParams& params, LiftState& state) {
  const std::array<double, 3> now = meanOf(in);
  double squares = 0.0;
  for (std::size_t k = 0; k < now.size(); ++k) {
    const double change = now[k] - state.resting[k];
    squares += maths::square(change);
    state.resting[k] += kMessageSeconds / params.restSeconds * change;
  }
  return std::sqrt(squares);
}

void feelFooting(Footing footing, const LiftParams& params, LiftState& state) {
  if (footing != state.footing) {
    state.pressed = state.rested = false;
    state.free = state.footed = 0.0;
  }
  state.footing = footing;
  state.footed += kMessageSeconds;
  const bool still = std::min(state.still, state.footed) >= params.restSeconds;
  state.rested = state.rested || still || state.footed >= params.settles;
}

void feelPaw(LiftState& state) {
  state.believed = state.pressed = true;
  state.moved = false;
  state.blindly = 0;
}

// Whether free paws show now that it is lifted.
bool tells(const LiftParams& params, const LiftState& state) {
  switch (state.footing) {
    case Footing::stands:
    case Footing::getsUp: return true;
    case Footing::standsUp: return state.pressed;
    case Footing::lies: return state.rested && state.still <= params.jolt;
    default: return false;
  }
}

double secondsNeeded(const LiftParams& params, const LiftState& state) {
  if (state.footing == Footing::lies) return params.lyingSeconds;
  return state.footing == Footing::getsUp ? params.gettingUpSeconds : params.freeSeconds;
}

bool upright(const LiftParams& params, const LiftState& state) {
  return state.resting[2] >= params.uprightAbove;
}

double stillNeeded(bool paw, const LiftParams& params, const LiftState& state) {
  if (paw) return params.stillSeconds;
  return upright(params, state) ? params.stillWithoutPaw : params.stillOnSide;
}

// Switches that fail would have the robot rise and collapse for ever.
void putDown(bool paw, const LiftParams& params, LiftState& state) {
  constexpr std::uint8_t kBelieved = 2;  // times
  state.lifted = state.moved = false;
  state.free = 0.0;
  if (!paw && upright(params, state)) ++state.blindly;
  if (state.blindly >= kBelieved) state.believed = false;
}

}  // namespace

void stepLifted(const MotionInput& in, Footing footing, const LiftParams& params,
                LiftState& state) {
  const bool paw = anyPressed(in);
  const bool moves = movement(in, params, state) > params.stillBelow;
  state.still = moves ? 0.0 : state.still + kMessageSeconds;
  feelFooting(footing, params, state);
  if (paw) feelPaw(state);
  state.moved = state.moved || (moves && !paw);
  if (state.lifted) {
    if (state.still >= stillNeeded(paw, params, state)) putDown(paw, params, state);
    return;
  }
  const bool free = !paw && tells(params, state);
  state.free = free ? state.free + kMessageSeconds : 0.0;
  state.lifted = state.believed && state.moved && state.free >= secondsNeeded(params, state);
  if (state.lifted) state.still = 0.0;
}

}  // namespace kelpie::actuator
