// SPDX-License-Identifier: Apache-2.0
#include "actuator/odometry/BodyOscillation.h"

#include <cmath>

namespace kelpie::actuator {
namespace {

Wave wave(double size, const maths::SinCos& angle) { return {size * angle.cos, size * angle.sin}; }

double sum(const Wave& factor, const Wave& w) {
  return factor.cosine * w.cosine + factor.sine * w.sine;
}

double oscillationOf(const OscillationCurve& c, const OscillationCurve& f) {
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

StrideParts partsOf(const Stride& stride, const StrokeLimits& max) {
  const auto& [feet, phase] = stride;
  StrideParts parts;
  parts.on = phase.lift;
  parts.forward = feet.forward / (feet.forward < 0.0 ? max.back : max.forward);
  parts.left = feet.left / max.left;
  parts.turn = feet.turn / max.turn;
  parts.phase = phase.phase;
  parts.once = maths::sinCos(2.0 * maths::kPi * phase.phase);
  parts.twice = maths::sinCos(4.0 * maths::kPi * phase.phase);
  return parts;
}

OscillationCurve factorsOf(const StrideParts& parts, OscillationSymmetry side) {
  const bool same = side == OscillationSymmetry::same;
  const auto& [on, forward, left, turn, phase, once, twice] = parts;
  OscillationCurve f;
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

OscillationCurve oscillationFactors(const Stride& stride, const StrokeLimits& max,
                                    OscillationSymmetry side) {
  return factorsOf(partsOf(stride, max), side);
}

Stance oscillating(const Stance& legs, const Stride& stride, const WalkSet& set) {
  if (standing(stride.phase)) return legs;
  const WalkOscillation& oscillation = set.oscillation;
  const StrideParts parts = partsOf(stride, set.max);
  const OscillationCurve same = factorsOf(parts, OscillationSymmetry::same);
  const OscillationCurve opposite = factorsOf(parts, OscillationSymmetry::opposite);
  return {legs.shoulderHeight + oscillationOf(oscillation.height, same),
          legs.bodyTilt + Angle::rad(oscillationOf(oscillation.tilt, same)),
          legs.bodyRoll + Angle::rad(oscillationOf(oscillation.roll, opposite))};
}

Swing swing(const Stride& stride, const WalkSet& set) {
  if (standing(stride.phase)) return {};
  const StrideParts parts = partsOf(stride, set.max);
  const OscillationCurve opposite = factorsOf(parts, OscillationSymmetry::opposite);
  return {oscillationOf(set.oscillation.forward, factorsOf(parts, OscillationSymmetry::same)),
          oscillationOf(set.oscillation.left, opposite),
          oscillationOf(set.oscillation.turn, opposite)};
}

}  // namespace kelpie::actuator
