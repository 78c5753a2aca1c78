// SPDX-License-Identifier: Apache-2.0
// Labelled pixels, for training colour tables. From a CSV with the header Y,Cr,Cb,class, or from a
// text that names boxes in images:
//
//   # image, relative to this file; left, top, right, bottom in pixels, the last two exclusive;
//   # class
//   shots/goal.png 40 20 90 60 blue
//
// A class is one of kColourNames or a number of the 2005 release
// (../shared/data/colour/classes.csv). Errors name the file and the line.
#pragma once

#include <string>
#include <vector>

#include "robot/core/Expected.h"
#include "robot/core/Random.h"
#include "vision/colour/ColourClass.h"
#include "vision/colour/RingTable.h"

namespace kelpie::calibrate {

struct LabelledPixel {
  Yuv value;
  vision::ColourClass colour = vision::ColourClass::none;
};
using LabelledPixels = std::vector<LabelledPixel>;

std::string colourClassList();  // "none, orange, ..."
Expected<vision::ColourClass> colourClassOf(const std::string& text);

Expected<LabelledPixels> readLabelledCsv(const std::string& path);
// Pixels of the boxes, corrected by `ring`: the table is for corrected pixels.
Expected<LabelledPixels> readRegions(const std::string& path, const vision::RingTable& ring);

// A part held out of training.
struct Split {
  LabelledPixels training;
  LabelledPixels heldOut;
};
Split splitLabelled(const LabelledPixels& pixels, double heldOutShare, Random& random);

}  // namespace kelpie::calibrate
