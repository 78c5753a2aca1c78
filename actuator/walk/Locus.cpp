// SPDX-License-Identifier: Apache-2.0
#include "actuator/walk/Locus.h"

#include <cmath>

#include "robot/core/Maths.h"

namespace kelpie::actuator {
namespace {

constexpr double kPress = 0.15;  // of the lift, that an elliptical stroke goes below the ground

// From -1 to 1 as `s` goes from 0 to 1, with that slope at both ends.
double swung(double s, double slope) {
  const double rise = s * s * (3.0 - 2.0 * s);
  return 2.0 * rise - 1.0 + slope * s * (1.0 - s) * (1.0 - 2.0 * s);
}

double ramp(double s) { return maths::clamp(s, 0.0, 1.0); }

// A third of the time goes up, a third across and a third down.
LocusPoint rectangularSwing(double s, double slope) {
  constexpr double kPart = 1.0 / 3.0;
  const double rise = ramp(s / kPart);
  const double fall = ramp((1.0 - s) / kPart);
  return {swung(ramp((s - 0.5 * kPart) / (1.0 - kPart)), slope * (1.0 - kPart)),
          std::fmin(rise, fall)};
}

}  // namespace

LocusPoint locusPoint(LocusShape shape, double phase, double duty, double lead) {
  const bool stroke = phase < duty;
  const double s = stroke ? phase / duty : (phase - duty) / (1.0 - duty);
  if (shape == LocusShape::elliptical) {
    const maths::SinCos turn = maths::sinCos(maths::kPi * s);
    return stroke ? LocusPoint{turn.cos, -kPress * turn.sin} : LocusPoint{-turn.cos, turn.sin};
  }
  if (stroke) return {1.0 - 2.0 * s, 0.0};
  const double slope = -lead * 2.0 * (1.0 - duty) / duty;
  if (shape == LocusShape::rectangular) return rectangularSwing(s, slope);
  return {swung(s, slope), maths::sinCos(maths::kPi * s).sin};
}

}  // namespace kelpie::actuator
