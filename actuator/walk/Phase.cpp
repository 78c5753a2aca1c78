// SPDX-License-Identifier: Apache-2.0
#include "actuator/walk/Phase.h"

#include <cmath>

#include "robot/body/Legs.h"
#include "robot/core/Maths.h"

namespace kelpie::actuator {
namespace {

double wrapped(double phase) { return phase - std::floor(phase); }

// The pair whose stroke begins at 0.
bool isFirstPair(LegId leg) { return leg == LegId::leftFront || leg == LegId::rightHind; }

}  // namespace

void stepPhase(bool walking, const GaitParams& gait, PhaseState& state) {
  const double halfStep = std::fmax(gait.halfStepTicks, 1.0);
  const double change = (walking ? 1.0 : -1.0) / halfStep;
  state.lift = maths::clamp(state.lift + change, 0.0, 1.0);
  if (standing(state)) return;
  state.phase = wrapped(state.phase + 0.5 / halfStep);
}

double footPhase(LegId leg, const GaitParams& gait, const PhaseState& state) {
  const double pair = isFirstPair(leg) ? 0.0 : 0.5;
  const double ahead = body::isFront(leg) ? 0.0 : gait.hindPhase;
  return wrapped(state.phase + pair + ahead);
}

}  // namespace kelpie::actuator
