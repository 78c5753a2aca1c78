// SPDX-License-Identifier: Apache-2.0
// How a body moves to and fro in its walk, as numbers of that walk; what they mean is in
// BodyOscillation.h. `kelpie calibrate walk` fits them.
#pragma once

#include "robot/core/fields/Fields.h"

namespace kelpie::actuator {

// One part of a sway that comes round each step, or twice in it, by the phase of the walk.
struct Wave {
  double cosine = 0.0;
  double sine = 0.0;

  template <int = 0>
  static constexpr auto fields() {
    return fieldList(field("cosine", &Wave::cosine, "", -1, 1),
                     field("sine", &Wave::sine, "", -1, 1));
  }
};

// How one quantity differs, while the robot walks, from what its legs or its odometry say: by
// stepping at all, and at the whole stroke ahead, sideways and in a turn (BodyOscillation.h); rad
// or cm.
struct OscillationCurve {
  double step = 0.0;
  double forward = 0.0;
  double left = 0.0;
  double turn = 0.0;
  Wave stepWave;
  Wave forwardWave;
  Wave leftWave;
  Wave turnWave;
  // Two times more a step than the waves above.
  Wave stepRipple;
  Wave forwardRipple;
  // Of the stroke sideways and in a turn, the same either way.
  Wave leftEither;
  Wave turnEither;

  template <int = 0>
  static constexpr auto fields() {
    using P = OscillationCurve;
    return fieldList(field("step", &P::step, "", -1, 1), field("forward", &P::forward, "", -1, 1),
                     field("left", &P::left, "", -1, 1), field("turn", &P::turn, "", -1, 1),
                     field("stepWave", &P::stepWave), field("forwardWave", &P::forwardWave),
                     field("leftWave", &P::leftWave), field("turnWave", &P::turnWave),
                     field("stepRipple", &P::stepRipple), field("forwardRipple", &P::forwardRipple),
                     field("leftEither", &P::leftEither), field("turnEither", &P::turnEither));
  }
};

struct WalkOscillation {
  OscillationCurve tilt;
  OscillationCurve roll;
  OscillationCurve height;
  OscillationCurve forward;
  OscillationCurve left;
  OscillationCurve turn;

  template <int = 0>
  static constexpr auto fields() {
    using P = WalkOscillation;
    return fieldList(field("tilt", &P::tilt), field("roll", &P::roll), field("height", &P::height),
                     field("forward", &P::forward), field("left", &P::left),
                     field("turn", &P::turn));
  }
};

}  // namespace kelpie::actuator
