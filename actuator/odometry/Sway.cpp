// SPDX-License-Identifier: Apache-2.0
#include "actuator/odometry/Sway.h"

#include <cmath>

namespace kelpie::actuator {
namespace {

Wave wave(double size, const maths::SinCos& angle) { return {size * angle.cos, size * angle.sin}; }

double sum(const Wave& factor, const Wave& w) {
  return factor.cosine * w.cosine + factor.sine * w.sine;
}

double swayOf(const SwayCurve& c, const SwayCurve& f) {
  return f.step * c.step + f.forward * c.forward + f.left * c.left + f.turn * c.turn +
         sum(f.stepWave, c.stepWave) + sum(f.forwardWave, c.forwardWave) +
         sum(f.leftWave, c.leftWave) + sum(f.turnWave, c.turnWave) +
         sum(f.stepRipple, c.stepRipple) + sum(f.forwardRipple, c.forwardRipple) +
         sum(f.leftEither, c.leftEither) + sum(f.turnEither, c.turnEither);
}

// What the factors of both sides are made of.
struct StrideParts {
  double on = 0.0;
  double forward = 0.0;  // shares of the whole stroke
  double left = 0.0;
  double turn = 0.0;
  double phase = 0.0;
  maths::SinCos once{};
  maths::SinCos twice{};
};

StrideParts partsOf(const Stride& stride, const StrokeLimits& most) {
  const auto& [feet, phase] = stride;
  StrideParts parts;
  parts.on = phase.lift;
  parts.forward = feet.forward / (feet.forward < 0.0 ? most.back : most.forward);
  parts.left = feet.left / most.left;
  parts.turn = feet.turn / most.turn;
  parts.phase = phase.phase;
  parts.once = maths::sinCos(2.0 * maths::kPi * phase.phase);
  parts.twice = maths::sinCos(4.0 * maths::kPi * phase.phase);
  return parts;
}

SwayCurve factorsOf(const StrideParts& parts, SwaySide side) {
  const bool same = side == SwaySide::same;
  const auto& [on, forward, left, turn, phase, once, twice] = parts;
  SwayCurve f;
  f.step = same ? on : 0.0;
  f.forward = same ? on * forward : 0.0;
  f.left = on * (same ? std::fabs(left) : left);
  f.turn = on * (same ? std::fabs(turn) : turn);
  f.stepWave = wave(on, same ? twice : once);
  f.forwardWave = wave(on * forward, same ? twice : once);
  f.leftWave = wave(on * left, same ? once : twice);
  f.turnWave = wave(on * turn, same ? once : twice);
  const maths::SinCos more = maths::sinCos((same ? 8.0 : 6.0) * maths::kPi * phase);
  f.stepRipple = wave(on, more);
  f.forwardRipple = wave(on * forward, more);
  f.leftEither = wave(on * std::fabs(left), same ? twice : once);
  f.turnEither = wave(on * std::fabs(turn), same ? twice : once);
  return f;
}

}  // namespace

SwayCurve swayFactors(const Stride& stride, const StrokeLimits& most, SwaySide side) {
  return factorsOf(partsOf(stride, most), side);
}

Stance swaying(const Stance& legs, const Stride& stride, const WalkSet& set) {
  if (standing(stride.phase)) return legs;
  const WalkSway& sway = set.sway;
  const StrideParts parts = partsOf(stride, set.most);
  const SwayCurve same = factorsOf(parts, SwaySide::same);
  const SwayCurve opposite = factorsOf(parts, SwaySide::opposite);
  return {legs.shoulderHeight + swayOf(sway.height, same),
          legs.bodyTilt + Angle::rad(swayOf(sway.tilt, same)),
          legs.bodyRoll + Angle::rad(swayOf(sway.roll, opposite))};
}

Swing swing(const Stride& stride, const WalkSet& set) {
  if (standing(stride.phase)) return {};
  const StrideParts parts = partsOf(stride, set.most);
  const SwayCurve opposite = factorsOf(parts, SwaySide::opposite);
  return {swayOf(set.sway.forward, factorsOf(parts, SwaySide::same)),
          swayOf(set.sway.left, opposite), swayOf(set.sway.turn, opposite)};
}

}  // namespace kelpie::actuator
