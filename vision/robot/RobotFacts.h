// SPDX-License-Identifier: Apache-2.0
// Whether what passed every check is a robot: plain facts of its largest patch and of all of them,
// and the log odds against a robot. Specks on clothes beyond the carpet and patches placed too far,
// because something hides the feet, pass each single check now and then. Weak for a robot of which
// one small patch shows at the carpet's edge.
#pragma once

#include "robot/core/fields/Fields.h"

namespace kelpie::vision {

struct RobotFacts {
  double patches = 1.0;
  double samples = 0.0;  // lattice samples of all patches
  // The largest patch:
  double ownShare = 0.0;     // share of its colour inside its box
  double meanIsOwn = 0.0;    // 1: its mean colour is the uniform's
  double patchWidth = 0.0;   // cm
  double patchHeight = 0.0;  // cm
  // Cm of its middle from a trunk's height, as it would count in settled play.
  double heightError = 0.0;
  double carpetBeyond = 0.0;   // cm of carpet from its foot to the field edge
  double footBelowEdge = 0.0;  // px of its foot below the field edge
  double footCut = 0.0;        // 1: the image ends before the foot

  template <int = 0>
  static constexpr auto fields() {
    using Facts = RobotFacts;
    return fieldList(
        field("patches", &Facts::patches), field("samples", &Facts::samples),
        field("ownShare", &Facts::ownShare), field("meanIsOwn", &Facts::meanIsOwn),
        field("patchWidth", &Facts::patchWidth), field("patchHeight", &Facts::patchHeight),
        field("heightError", &Facts::heightError), field("carpetBeyond", &Facts::carpetBeyond),
        field("footBelowEdge", &Facts::footBelowEdge), field("footCut", &Facts::footCut));
  }
};

}  // namespace kelpie::vision
