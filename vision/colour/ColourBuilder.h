// SPDX-License-Identifier: Apache-2.0
// Makes a colour table from one nominal colour per class, for the simulated world and for a robot
// without a calibration of its own. Start-up only (a few ms on the PC).
#pragma once

#include <vector>

#include "robot/core/fields/Fields.h"
#include "vision/colour/ColourTable.h"

namespace kelpie::vision {

// A class's colour in even light. Shading scales Y; the chroma follows half-way.
struct Prototype {
  ColourClass colour = ColourClass::none;
  double y = 128.0;
  double cr = 128.0;
  double cb = 128.0;
  double darkest = 0.5;    // share of y that shade leaves
  double brightest = 1.4;  // share of y that glare adds up to
  double radius = 24.0;    // largest distance in chroma, grey levels
};

// Mean colours of the released 2005 table (facts-2005 section 3), which the simulated field wears.
std::vector<Prototype> nominalPrototypes();

// Every cell gets the nearest prototype's class, `none` where none is near.
ColourTable buildColourTable(const std::vector<Prototype>& prototypes);

// The same table for a field whose landmarks are overexposed: of what it calls white or nothing,
// that which is nearer to a landmark's colour in glare. Noisier: pixels of white are 10 grey levels
// of Cb from it.
ColourTable withGlare(const ColourTable& even);

}  // namespace kelpie::vision
