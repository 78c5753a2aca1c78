// SPDX-License-Identifier: Apache-2.0
// Tunables of the search for beacons: posts 40 cm high with two coloured bands of 10 cm over white.
#pragma once

#include "robot/core/Angle.h"
#include "robot/core/fields/Fields.h"

namespace kelpie::vision {

struct BeaconFinderParams {
  double minSamples = 2;  // lattice samples of pink
  double minBand = 2.0;   // px, each coloured band
  double maxRatio = 1.6;  // of the two bands' heights; beyond, one runs on into something else
  double maxBelowHorizon = 25;             // px, facts-2005 4.5 check 5
  Angle elevationError = Angle::deg(1.7);  // four standard deviations in settled play
  double maxDistance = 500;                // beyond, two pixels of clothes pass for a band
  double maxLogOddsAgainst = -0.2;         // of the candidate's facts (BeaconCurves.h)
  double edgeSd = 0.35;                    // px, of each band edge
  double edgeBias = 0.0;  // px of this camera, by which a whole height is measured too large
  Angle headingSd = Angle::deg(0.7);

  template <int = 0>
  static constexpr auto fields() {
    using P = BeaconFinderParams;
    return fieldList(
        field("minSamples", &P::minSamples, "", 1, 100), field("minBand", &P::minBand, "px", 1, 50),
        field("maxRatio", &P::maxRatio, "", 1, 10),
        field("maxBelowHorizon", &P::maxBelowHorizon, "px", -160, 160),
        field("elevationError", &P::elevationError, "rad", 0, 45),
        field("maxDistance", &P::maxDistance, "cm", 50, 1000),
        field("maxLogOddsAgainst", &P::maxLogOddsAgainst, "", -50, 50),
        field("edgeSd", &P::edgeSd, "px", 0.01, 5), field("edgeBias", &P::edgeBias, "px", -5, 5),
        field("headingSd", &P::headingSd, "rad", 0.01, 20));
  }
};

}  // namespace kelpie::vision
