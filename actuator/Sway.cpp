// SPDX-License-Identifier: Apache-2.0
#include "actuator/Sway.h"

#include <cmath>

namespace kelpie::actuator {
namespace {

Wave wave(double size, const maths::SinCos& angle) { return {size * angle.cos, size * angle.sin}; }

double sum(const Wave& factor, const Wave& w) {
  return factor.cosine * w.cosine + factor.sine * w.sine;
}

double swayOf(const SwayCurve& c, const Stride& stride, const StrokeLimits& most, SwaySide side) {
  const SwayCurve f = swayFactors(stride, most, side);
  return f.step * c.step + f.forward * c.forward + f.left * c.left + f.turn * c.turn +
         sum(f.stepWave, c.stepWave) + sum(f.forwardWave, c.forwardWave) +
         sum(f.leftWave, c.leftWave) + sum(f.turnWave, c.turnWave) +
         sum(f.stepRipple, c.stepRipple) + sum(f.forwardRipple, c.forwardRipple) +
         sum(f.leftEither, c.leftEither) + sum(f.turnEither, c.turnEither);
}

}  // namespace

SwayCurve swayFactors(const Stride& stride, const StrokeLimits& most, SwaySide side) {
  const auto& [feet, phase] = stride;
  const bool same = side == SwaySide::same;
  const double forward = feet.forward / (feet.forward < 0.0 ? most.back : most.forward);
  const double left = feet.left / most.left;
  const double turn = feet.turn / most.turn;
  const maths::SinCos once = maths::sinCos(2.0 * maths::kPi * phase.phase);
  const maths::SinCos twice = maths::sinCos(4.0 * maths::kPi * phase.phase);
  const double on = phase.lift;
  SwayCurve f;
  f.step = same ? on : 0.0;
  f.forward = same ? on * forward : 0.0;
  f.left = on * (same ? std::fabs(left) : left);
  f.turn = on * (same ? std::fabs(turn) : turn);
  f.stepWave = wave(on, same ? twice : once);
  f.forwardWave = wave(on * forward, same ? twice : once);
  f.leftWave = wave(on * left, same ? once : twice);
  f.turnWave = wave(on * turn, same ? once : twice);
  const maths::SinCos more = maths::sinCos((same ? 8.0 : 6.0) * maths::kPi * phase.phase);
  f.stepRipple = wave(on, more);
  f.forwardRipple = wave(on * forward, more);
  f.leftEither = wave(on * std::fabs(left), same ? twice : once);
  f.turnEither = wave(on * std::fabs(turn), same ? twice : once);
  return f;
}

Stance swaying(const Stance& legs, const Stride& stride, const WalkSet& set) {
  if (standing(stride.phase)) return legs;
  const WalkSway& sway = set.sway;
  return {legs.shoulderHeight + swayOf(sway.height, stride, set.most, SwaySide::same),
          legs.bodyTilt + Angle::rad(swayOf(sway.tilt, stride, set.most, SwaySide::same)),
          legs.bodyRoll + Angle::rad(swayOf(sway.roll, stride, set.most, SwaySide::opposite))};
}

Swing swing(const Stride& stride, const WalkSet& set) {
  if (standing(stride.phase)) return {};
  return {swayOf(set.sway.forward, stride, set.most, SwaySide::same),
          swayOf(set.sway.left, stride, set.most, SwaySide::opposite),
          swayOf(set.sway.turn, stride, set.most, SwaySide::opposite)};
}

}  // namespace kelpie::actuator
