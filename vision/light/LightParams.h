// SPDX-License-Identifier: Apache-2.0
// How the colour table follows the light: the colours that its surfaces have in the light that it
// was made for, and how far each kind of surface is trusted to tell another light. Standard
// deviations are of natural logarithms, so 0.1 is a tenth of the brightness.
#pragma once

#include "robot/core/fields/Fields.h"

namespace kelpie::vision {

struct SurfaceColour {
  double y = 128.0;
  double cr = 128.0;
  double cb = 128.0;

  template <int = 0>
  static constexpr auto fields() {
    return fieldList(field("y", &SurfaceColour::y, "levels", 10, 255),
                     field("cr", &SurfaceColour::cr, "levels", 0, 255),
                     field("cb", &SurfaceColour::cb, "levels", 0, 255));
  }
};

struct LightParams {
  bool follow = true;
  // The nominal table's (ColourBuilder.cpp); of a table from a file the ones that it was made with.
  SurfaceColour carpet{77, 103, 97};
  SurfaceColour line{189, 124, 129};
  SurfaceColour blue{82, 121, 167};
  SurfaceColour yellow{120, 160, 61};
  SurfaceColour pink{113, 193, 124};
  double brightnessSd = 0.4;  // of lights, before anything is seen
  double colourSd = 0.2;      // of how much more than the brightness colours change
  // Carpets differ by 0.7 to 1.3 from each other in the same light (tools/sim/bodies/
  // Randomisation.h), so they tell little; lines are painted white.
  double carpetSd = 0.2;
  double lineSd = 0.1;
  double landmarkSd = 0.1;
  double frameSd = 0.2;       // of what one image tells, besides
  double memory = 150.0;      // images over which it is averaged
  double unlike = 0.4;        // landmarks farther off than that are not of this light alone
  double glareImages = 12.0;  // without a landmark where one should show: it may be overexposed
  double leastStep = 0.03;    // of a gain that is worth making tables anew
  double mostStep = 0.15;     // at once
  double least = 0.4;         // of the light that the table was made for
  double most = 2.0;

  template <int = 0>
  static constexpr auto fields() {
    using P = LightParams;
    return fieldList(
        field("follow", &P::follow), field("carpet", &P::carpet), field("line", &P::line),
        field("blue", &P::blue), field("yellow", &P::yellow), field("pink", &P::pink),
        field("brightnessSd", &P::brightnessSd, "", 0.01, 2),
        field("colourSd", &P::colourSd, "", 0.01, 2), field("carpetSd", &P::carpetSd, "", 0.01, 2),
        field("lineSd", &P::lineSd, "", 0.01, 2), field("landmarkSd", &P::landmarkSd, "", 0.01, 2),
        field("frameSd", &P::frameSd, "", 0.01, 2), field("memory", &P::memory, "", 1, 10000),
        field("unlike", &P::unlike, "", 0, 2), field("glareImages", &P::glareImages, "", 1, 10000),
        field("leastStep", &P::leastStep, "", 0.001, 1),
        field("mostStep", &P::mostStep, "", 0.001, 1), field("least", &P::least, "", 0.1, 1),
        field("most", &P::most, "", 1, 4));
  }
};

}  // namespace kelpie::vision
