// SPDX-License-Identifier: Apache-2.0
// Trains a colour table from labelled pixels. Like the 2005 team's tool (facts-2005 section 3)
// every pixel adds a bump to its class over the cells around it and the highest class takes the
// cell; own design: the bump is a Gaussian cut off at `reach` widths, its width grows where pixels
// are few (Abramson's rule), a common class is held back, and the widths are checked by
// cross-validation on the table itself, rounding of the cells included. Cells that no bump reaches
// are `none`. Fails on nothing; an empty training set gives an empty table.
#pragma once

#include <array>
#include <vector>

#include "tools/calibrate/Labels.h"
#include "vision/pixels/ColourTable.h"

namespace kelpie::calibrate {

struct TableBits {
  int y = vision::ColourTable::kBitsY;
  int cr = vision::ColourTable::kBitsCr;
  int cb = vision::ColourTable::kBitsCb;
};

struct KernelParams {
  double widthY = 4.0;       // grey levels, sd of a bump
  double widthChroma = 4.0;  // grey levels
  double adapts = 0.25;      // exponent of the width's growth with 1 / density
  double balance = -0.15;    // a class counts with the number of its pixels to this power
  double reach = 4.0;        // widths
};

// A colour table of any size.
struct GridTable {
  TableBits bits;
  std::vector<vision::ColourClass> cells;

  std::size_t cellOf(Yuv p) const;
  vision::ColourClass operator()(Yuv p) const { return cells[cellOf(p)]; }
};

GridTable trainTable(const LabelledPixels& pixels, const KernelParams& params,
                     const TableBits& bits);
// The default parameters, or those of a fixed set that fourfold cross-validation finds clearly
// better.
KernelParams chooseKernel(const LabelledPixels& pixels, const TableBits& bits, Random& random);
// The colour table of a grid that has the robot's bits.
vision::ColourTable robotTable(const GridTable& grid);

// [labelled][found] in pixels.
using Confusion = std::array<std::array<int, vision::kColourClassCount>, vision::kColourClassCount>;

template <class Table>
Confusion confusionOf(const Table& table, const LabelledPixels& pixels) {
  Confusion confusion{};
  for (const LabelledPixel& p : pixels)
    ++confusion[vision::index(p.colour)][vision::index(table(p.value))];
  return confusion;
}
double accuracyOf(const Confusion& confusion);

// Commonest class of the `count` labelled pixels nearest in colour: the reference for accuracies.
vision::ColourClass nearestNeighbours(const LabelledPixels& pixels, Yuv value, std::size_t count);

}  // namespace kelpie::calibrate
