// SPDX-License-Identifier: Apache-2.0
// Where a beacon may begin: samples of pink, blue or yellow right above white, grouped where they
// touch. Unlike the middle of a pink patch these places do not move when clothes of the same colour
// are seen beside or above the bands. Nothing where something hides the white part.
#pragma once

#include "robot/core/ScratchVector.h"
#include "vision/Scene.h"

namespace kelpie::vision {

struct BeaconFoot {
  ColourClass colour = ColourClass::none;  // of the lower band
  double left = 0.0;                       // level u of the outermost samples
  double right = 0.0;
  double v = 0.0;       // level row of the last found sample
  double lowest = 0.0;  // the largest v
  int samples = 0;
};

constexpr std::size_t kMaxBeaconFeet = 64;
using BeaconFeet = ScratchVector<BeaconFoot, kMaxBeaconFeet>;
BeaconFeet findBeaconFeet(const Scene& scene);

}  // namespace kelpie::vision
