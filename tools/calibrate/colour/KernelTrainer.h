// SPDX-License-Identifier: Apache-2.0
// Trains a colour table from labelled pixels by penalised logistic regression on Gaussian bumps
// (kernel logistic regression), one at each cell of the table that has a label; own design. The
// 2005 team's tool (facts-2005 section 3) and ours before it gave a cell to the class with the
// highest density there, which is worse where two classes lie in one another, as ball and beacon
// pink do. A class counts by what missing it costs a player, a common one is held back. Cells that
// no label is near to are `none`. Fails on nothing; without labels every colour is `none`.
#pragma once

#include <array>
#include <vector>

#include "tools/calibrate/colour/Labels.h"
#include "vision/colour/ColourTable.h"

namespace kelpie::calibrate {

struct TableBits {
  int y = vision::ColourTable::kBitsY;
  int cr = vision::ColourTable::kBitsCr;
  int cb = vision::ColourTable::kBitsCb;
};

// Held out from the 2,616 labels, accuracy is within 0.003 for widths of 12 to 16, penalties of 0.1
// to 1 and 100 to 300 rounds; narrower bumps follow single labels, wider ones lose grey. Of pixels
// held out 99.5 % have another's label within 12 levels, all but one in 654 within 15.
struct KernelParams {
  double width = 12.0;       // grey levels, sd of a bump
  double reach = 3.0;        // widths
  double noneBeyond = 20.0;  // grey levels from the nearest label
  double penalty = 0.3;      // of squared heights, in labelled pixels
  double balance = -0.15;    // a class counts with the number of its pixels to this power
  double ballCost = 1.3;     // of a ball's pixel missed; 1 for those of other classes
  int rounds = 200;
};

using ClassScores = std::array<double, vision::kColourClassCount>;
using ColourPlace = std::array<double, 3>;  // Y, Cr, Cb; the middle of a table's cell

struct ClassBump {
  ColourPlace at{};
  ClassScores height{};
};

// What training made of the labels. A colour is rounded to its cell first.
struct TrainedClasses {
  TableBits bits;
  KernelParams params;
  ClassScores weights{};  // of one label of each class; 0: has none, and takes no cell
  std::vector<ClassBump> bumps;

  vision::ColourClass operator()(Yuv p) const;
};

TrainedClasses trainClasses(const LabelledPixels& pixels, const KernelParams& params,
                            const TableBits& bits);
// The colour table of classes that were trained with the robot's bits.
vision::ColourTable robotTable(const TrainedClasses& trained);

// [labelled][found] in pixels.
using Confusion = std::array<std::array<int, vision::kColourClassCount>, vision::kColourClassCount>;

template <class Table>
Confusion confusionOf(const Table& table, const LabelledPixels& pixels) {
  Confusion confusion{};
  for (const LabelledPixel& p : pixels)
    ++confusion[vision::index(p.colour)][vision::index(table(p.value))];
  return confusion;
}
void addTo(Confusion& sum, const Confusion& more);
double accuracyOf(const Confusion& confusion);
// Of the pixels of a class, the share that is found; of those found, the share that is the class.
double recallOf(const Confusion& confusion, vision::ColourClass c);
double precisionOf(const Confusion& confusion, vision::ColourClass c);

// Commonest class of the `count` labelled pixels nearest in colour: the reference for accuracies.
vision::ColourClass nearestNeighbours(const LabelledPixels& pixels, Yuv value, std::size_t count);

}  // namespace kelpie::calibrate
