// SPDX-License-Identifier: Apache-2.0
// Tunables of the search for pink patches, the landmarks of the 2004 localisation challenge (thesis
// 2004 section 4.1.1). As they are, only what stands on the carpet is reported, so that spectators
// in pink do no harm; for sheets on the outer wall set onField to false.
#pragma once

#include "robot/core/Angle.h"
#include "robot/core/fields/Fields.h"

namespace kelpie::vision {

struct PinkFinderParams {
  bool wanted = true;
  bool onField = true;    // it stands on the carpet; false: anywhere
  double minSamples = 8;  // of the lattice: 30 px, thesis 2004 section 4.1.1
  double minSize = 4;     // px, of width and height; the same
  // Pink among all pixels of its upright box. The thesis asks for 0.85 of the box of its pixels;
  // ours reaches to where the colour is half gone, which is 0.79 for a sheet at 190 cm.
  double minDensity = 0.7;
  double maxNear = 3;                   // px from a beacon's box: a part of the beacon
  Angle maxElevation = Angle::deg(25);  // 35 cm high seen from 12 cm at 50 cm
  double minCarpetBehind = 2;           // px of green beside it, above its foot's level
  double sureDistance = 100;            // cm, of one whose surroundings are not in the image
  // Cm of its lower edge above the ground at its foot's distance. A thing on the floor 30 cm beyond
  // the carpet seems to hover by 17 * 30 / (d + 30): 2.2 cm at 200 cm, 3.9 at 100.
  double maxLift = 2;
  double knownHeight = 0;             // cm, upright, 0: not known
  double maxDistance = 300;           // cm
  double edgeSd = 0.5;                // px, of each edge
  Angle directionSd = Angle::deg(1);  // camera against ground, while walking
  Angle headingSd = Angle::deg(0.7);

  template <int = 0>
  static constexpr auto fields() {
    using P = PinkFinderParams;
    return fieldList(field("wanted", &P::wanted), field("onField", &P::onField),
                     field("minSamples", &P::minSamples, "", 1, 1000),
                     field("minSize", &P::minSize, "px", 1, 100),
                     field("minDensity", &P::minDensity, "", 0, 1),
                     field("maxNear", &P::maxNear, "px", 0, 50),
                     field("maxElevation", &P::maxElevation, "rad", -90, 90),
                     field("minCarpetBehind", &P::minCarpetBehind, "px", -10, 10),
                     field("sureDistance", &P::sureDistance, "cm", 0, 500),
                     field("maxLift", &P::maxLift, "cm", -50, 100),
                     field("knownHeight", &P::knownHeight, "cm", 0, 100),
                     field("maxDistance", &P::maxDistance, "cm", 50, 1000),
                     field("edgeSd", &P::edgeSd, "px", 0.01, 5),
                     field("directionSd", &P::directionSd, "rad", 0.05, 20),
                     field("headingSd", &P::headingSd, "rad", 0.01, 20));
  }
};

}  // namespace kelpie::vision
