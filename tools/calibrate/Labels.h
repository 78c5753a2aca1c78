// SPDX-License-Identifier: Apache-2.0
// Labelled pixels, for training colour tables. From a CSV with the header Y,Cr,Cb,class (class ids
// of the 2005 release, ../shared/data/colour/classes.csv), or from a text that names boxes in
// images:
//
//   # image, relative to this file; left, top, right, bottom in pixels, the last two exclusive;
//   class shots/goal.png 40 20 90 60 blue
//
// Errors name the file and the line.
#pragma once

#include <string>
#include <vector>

#include "robot/core/Expected.h"
#include "robot/core/Random.h"
#include "vision/ColourClass.h"
#include "vision/RingTable.h"

namespace kelpie::calibrate {

struct LabelledPixel {
  Yuv value;
  vision::ColourClass colour = vision::ColourClass::none;
};
using LabelledPixels = std::vector<LabelledPixel>;

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
