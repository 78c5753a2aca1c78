// SPDX-License-Identifier: Apache-2.0
#include "actuator/odometry/Odometry.h"

#include <cmath>

namespace kelpie::actuator {
namespace {

// The way of a tick, its turn in rad.
struct TickWay {
  double forward = 0.0;
  double left = 0.0;
  double turn = 0.0;
};

// Before so many ticks were commanded the ring's end is still a default one.
const CommandedTick& commanded(std::uint32_t back, const OdometryState& state) {
  if (state.count < back) return state.ticks.back();
  return state.ticks[(state.count - back) % state.ticks.size()];
}

TickWay wayOf(const CommandedTick& tick, const body::PlanarMotion& feet) {
  return {tick.real.forward * kTickSeconds + tick.joints.forward * feet.y,
          tick.real.left * kTickSeconds - tick.joints.left * feet.x,
          tick.real.turn * kTickSeconds + tick.joints.turn * feet.turn};
}

TickWay swung(const TickWay& way, const Swing& now, Swing& last) {
  const TickWay more{way.forward + now.forward - last.forward, way.left + now.left - last.left,
                     way.turn + now.turn - last.turn};
  last = now;
  return more;
}

void addVariance(const TickWay& way, const OdometryVariance& motion, const OdometryParams& p,
                 OdometryVariance& sum) {
  const double forward = std::fabs(way.forward);
  const double left = std::fabs(way.left);
  const double turn = std::fabs(way.turn);
  const double always = p.positionPerRad * turn;
  sum.forward += motion.forward + p.alongPerCm * forward + p.acrossPerCm * left + always;
  sum.left += motion.left + p.alongPerCm * left + p.acrossPerCm * forward + always;
  sum.turn += motion.turn + p.turnPerRad * turn + p.turnPerCm * (forward + left);
}

void compose(const TickWay& way, Odometry& sum) {
  const maths::SinCos turn = sum.turn.sinCos();
  sum.forward += way.forward * turn.cos - way.left * turn.sin;
  sum.left += way.forward * turn.sin + way.left * turn.cos;
  sum.turn = sum.turn + Angle::rad(way.turn);
}

}  // namespace

const CommandedTick& shown(std::size_t tick, const OdometryParams& params,
                           const OdometryState& state) {
  return commanded(static_cast<std::uint32_t>(kTicksPerMessage - tick) + params.delayTicks, state);
}

void recordLoad(double load, OdometryState& state) {
  constexpr double kSeconds = 2.0;  // of carpet and battery, not of somebody who pushes
  constexpr double kMax = 0.06;     // loads of free walks on varied models are within 0.03
  constexpr double kShare = kTicksPerMessage * kTickSeconds / kSeconds;
  state.load += kShare * (maths::clamp(load, -kMax, kMax) - state.load);
}

Felt felt(const Velocity& feet, OdometryState& state) {
  constexpr double kShare = kTickSeconds / 0.25;
  Velocity& lately = state.lately;
  const Velocity change{feet.forward - lately.forward, feet.left - lately.left,
                        feet.turn - lately.turn};
  lately = {lately.forward + kShare * change.forward, lately.left + kShare * change.left,
            lately.turn + kShare * change.turn};
  return {state.load, reachOf(state.reach), change};
}

void record(const CommandedTick& tick, OdometryState& state) {
  state.ticks[state.count++ % state.ticks.size()] = tick;
}

Odometry odometry(const MotionInput& in, const SensedPoses& poses, const OdometryParams& params,
                  OdometryState& state) {
  Odometry sum;
  for (std::uint32_t i = 0; i < kTicksPerMessage; ++i) {
    const body::PlanarMotion feet = stepFootMotion(in.sensors[i], poses[i], state.feet);
    const CommandedTick& tick = shown(i, params, state);
    stepReach(tick.commanded, !standing(tick.stride.phase), in.sensors[i].joints, state.reach);
    const TickWay way = wayOf(tick, feet);
    addVariance(way, tick.motion, params, sum.variance);
    compose(swung(way, tick.swing, state.swing), sum);
  }
  return sum;
}

}  // namespace kelpie::actuator
