// SPDX-License-Identifier: Apache-2.0
#include "actuator/feeling/HeldBall.h"

#include <cmath>

namespace kelpie::actuator {
namespace {

constexpr double kUnknownSag = 10.0;  // deg; a neck that says nothing shows no ball

bool holdingPose(const JointAngles& commanded, const HeldBallParams& params) {
  return commanded[Joint::neckTilt] < params.neckBelow &&
         commanded[Joint::mouth] < params.mouthBelow;
}

HeldBallTick felt(const SensorFrame& tick, const JointAngles& commanded) {
  const double sag = (commanded[Joint::neckTilt] - tick.joints[Joint::neckTilt]).deg();
  return {std::isfinite(sag) ? sag : kUnknownSag,
          std::isfinite(tick.chestDistance) ? tick.chestDistance : 0.0, tick.chin};
}

}  // namespace

bool stepHeldBall(const MotionInput& in, const JointAngles& commanded, const HeldBallParams& params,
                  HeldBallState& state) {
  if (!holdingPose(commanded, params)) {
    state.ticks = 0;
    return false;
  }
  for (const SensorFrame& tick : in.sensors)
    state.felt[state.ticks++ % state.felt.size()] = felt(tick, commanded);
  if (state.ticks < params.ticks) return false;
  double sag = 0.0;
  double chest = 0.0;
  bool chin = false;
  for (std::uint32_t back = 1; back <= params.ticks; ++back) {
    const HeldBallTick& tick = state.felt[(state.ticks - back) % state.felt.size()];
    sag += tick.sag / params.ticks;
    chest += tick.chest / params.ticks;
    chin = chin || tick.chin;
  }
  return chin || sag < params.sag.deg() || chest >= params.chest;
}

}  // namespace kelpie::actuator
