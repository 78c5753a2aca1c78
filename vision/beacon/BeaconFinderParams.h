// SPDX-License-Identifier: Apache-2.0
// Tunables of the search for beacons: posts 40 cm high with two coloured bands of 10 cm over white.
#pragma once

#include "robot/core/Angle.h"
#include "robot/core/Fields.h"

namespace kelpie::vision {

struct BeaconFinderParams {
  double minSamples = 2;             // lattice samples of pink
  double minBand = 2.0;              // px, each coloured band
  double maxRatio = 1.6;             // of the two bands' heights
  double maxAspect = 1.6;            // width to height of a band, and its inverse; the rule is 1
  double maxBelowHorizon = 25;       // px, facts-2005 4.5 check 5
  double minWhiteShare = 0.3;        // of the two bands below the coloured part
  double minUnsureWhiteShare = 0.5;  // of them, where the height does not fit the size well
  double maxFootAboveEdge = 4;       // px, of where its foot should be from the field edge
  double maxFootBelowEdge = 0.9;     // bands: beacons stand at most 20 cm inside the carpet's edge
  double maxBandWidths = 8;          // of its wider band to its width, where no white told its foot
  double maxCutBandWidths = 3;       // of them, when a band's end is hidden or cut
  Angle elevationError = Angle::deg(1.7);  // the camera's tilt is known to about a degree
  Angle sureElevation = Angle::deg(0.4);   // so small an error makes up for what is hidden or cut
  double maxSureAspect = 2.2;
  double maxWeakCues = 3;    // of the eight that weakCues counts
  double maxDistance = 500;  // beyond, two pixels of clothes pass for a band
  double edgeSd = 0.35;      // px, of each band edge
  Angle headingSd = Angle::deg(0.7);

  static constexpr auto fields() {
    return fieldList(
        field("minSamples", &BeaconFinderParams::minSamples, "", 1, 100),
        field("minBand", &BeaconFinderParams::minBand, "px", 1, 50),
        field("maxRatio", &BeaconFinderParams::maxRatio, "", 1, 10),
        field("maxAspect", &BeaconFinderParams::maxAspect, "", 1, 10),
        field("maxBelowHorizon", &BeaconFinderParams::maxBelowHorizon, "px", -160, 160),
        field("minWhiteShare", &BeaconFinderParams::minWhiteShare, "", 0, 1),
        field("minUnsureWhiteShare", &BeaconFinderParams::minUnsureWhiteShare, "", 0, 1),
        field("maxFootAboveEdge", &BeaconFinderParams::maxFootAboveEdge, "px", 0, 160),
        field("maxFootBelowEdge", &BeaconFinderParams::maxFootBelowEdge, "", 0, 20),
        field("sureElevation", &BeaconFinderParams::sureElevation, "rad", 0, 45),
        field("maxSureAspect", &BeaconFinderParams::maxSureAspect, "", 1, 10),
        field("maxBandWidths", &BeaconFinderParams::maxBandWidths, "", 1, 100),
        field("maxCutBandWidths", &BeaconFinderParams::maxCutBandWidths, "", 1, 100),
        field("elevationError", &BeaconFinderParams::elevationError, "rad", 0, 45),
        field("maxWeakCues", &BeaconFinderParams::maxWeakCues, "", 0, 8),
        field("maxDistance", &BeaconFinderParams::maxDistance, "cm", 50, 1000),
        field("edgeSd", &BeaconFinderParams::edgeSd, "px", 0.01, 5),
        field("headingSd", &BeaconFinderParams::headingSd, "rad", 0.01, 20));
  }
};

}  // namespace kelpie::vision
