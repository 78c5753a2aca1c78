// SPDX-License-Identifier: Apache-2.0
#include "actuator/Odometry.h"

#include <cmath>

namespace kelpie::actuator {
namespace {

// The way of a tick, its turn in rad.
struct TickWay {
  double forward = 0.0;
  double left = 0.0;
  double turn = 0.0;
};

CommandedTick commanded(std::uint32_t back, const OdometryState& state) {
  if (state.count < back || back > state.ticks.size()) return {};
  return state.ticks[(state.count - back) % state.ticks.size()];
}

TickWay wayOf(const CommandedTick& tick, const body::PlanarMotion& feet) {
  return {tick.real.forward * kTickSeconds + tick.joints.forward * feet.y,
          tick.real.left * kTickSeconds - tick.joints.left * feet.x,
          tick.real.turn * kTickSeconds + tick.joints.turn * feet.turn};
}

void addVariance(const TickWay& way, bool special, const OdometryParams& p, OdometryVariance& sum) {
  const double factor = special ? p.motionFactor : 1.0;
  const double forward = std::fabs(way.forward);
  const double left = std::fabs(way.left);
  const double turn = std::fabs(way.turn);
  const double always = p.positionPerRad * turn;
  sum.forward += factor * (p.alongPerCm * forward + p.acrossPerCm * left + always);
  sum.left += factor * (p.alongPerCm * left + p.acrossPerCm * forward + always);
  sum.turn += factor * (p.turnPerRad * turn + p.turnPerCm * (forward + left));
}

void compose(const TickWay& way, Odometry& sum) {
  sum.forward += way.forward * sum.turn.cos() - way.left * sum.turn.sin();
  sum.left += way.forward * sum.turn.sin() + way.left * sum.turn.cos();
  sum.turn = sum.turn + Angle::rad(way.turn);
}

}  // namespace

void record(const CommandedTick& tick, OdometryState& state) {
  state.ticks[state.count++ % state.ticks.size()] = tick;
}

Odometry odometry(const MotionInput& in, const OdometryParams& params, OdometryState& state) {
  Odometry sum;
  for (std::uint32_t i = 0; i < kTicksPerMessage; ++i) {
    const body::PlanarMotion feet = stepFootMotion(in.sensors[i], state.feet);
    const CommandedTick tick = commanded(kTicksPerMessage - i + params.delayTicks, state);
    const TickWay way = wayOf(tick, feet);
    addVariance(way, tick.special, params, sum.variance);
    compose(way, sum);
  }
  return sum;
}

}  // namespace kelpie::actuator
