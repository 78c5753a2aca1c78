// SPDX-License-Identifier: Apache-2.0
// Grid lines (rows and columns of the image, ten pixels apart) and the bright segments on them:
// brighter than the carpet on both sides, edges placed between pixels where the brightness is
// half-way. Brightness, not colour classes, because a line at 150 cm covers a third of a pixel and
// has the class of the carpet. Fails where the carpet itself changes its brightness by `minStep`
// within two pixels.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "robot/core/ScratchVector.h"
#include "robot/core/types/Geometry.h"
#include "vision/line/LinePointParams.h"
#include "vision/pixels/Sampler.h"

namespace kelpie::vision {

constexpr int kGridLeft = 4;  // px; 21 columns and 16 rows
constexpr int kGridTop = 4;
constexpr int kGridSpacing = 10;       // px, thesis 2004 3.1.1
constexpr int kFieldGridSpacing = 50;  // px, thesis 2004 3.1.2

// `length` pixels from (px, py) on, one step (dx, dy) apart, along a row or a column.
struct GridLine {
  int px = 0;
  int py = 0;
  int dx = 0;
  int dy = 0;
  int length = 0;

  int column(int i, int offset = 0) const { return px + dx * i + (dy != 0 ? offset : 0); }
  int row(int i, int offset = 0) const { return py + dy * i + (dx != 0 ? offset : 0); }
  // A place on the grid line, or `offset` pixels right of it (below it, if it runs along a row).
  PixelPoint at(double i, double offset = 0.0) const {
    return {px + 0.5 + dx * i + (dy != 0 ? offset : 0.0),
            py + 0.5 + dy * i + (dx != 0 ? offset : 0.0)};
  }
};

// A row from the middle column outwards.
GridLine gridLineOut(int py, int dx);
// A column from the lowest usable row up to `highest`; a row from left to right.
GridLine gridLineUp(int px, int highest);
GridLine gridLineRight(int py);

// Indices along a grid line; `first` and `last` are carpet, at most one pixel away from the bright
// ones.
struct BrightSegment {
  int first = 0;
  int last = 0;
  double from = 0.0;  // where the brightness is half-way
  double to = 0.0;
  double base = 0.0;   // brightness of the carpet
  double top = 0.0;    // brightness of the brightest pixel
  double paint = 0.0;  // px covered by paint: brightness above the carpet over that of full paint
  double middle() const { return 0.5 * (from + to); }
};
constexpr std::size_t kMaxBrightSegments = 32;  // of a grid line
using BrightSegments = ScratchVector<BrightSegment, kMaxBrightSegments>;

// In place of those that `found` held: a list of its own for each grid line was a fifth of what all
// finders wrote.
void findBrightSegments(const Sampler& sampler, const GridLine& gridLine,
                        const LinePointParams& params, BrightSegments& found);
BrightSegments brightSegments(const Sampler& sampler, const GridLine& gridLine,
                              const LinePointParams& params);

// An edge from carpet to something brighter, whatever comes after it.
struct RisingEdge {
  int first = 0;       // the carpet's last pixel
  int last = 0;        // the first pixel of full brightness
  double foot = 0.0;   // where the brightness is half-way
  double level = 0.0;  // the brightness there
};
constexpr std::size_t kMaxRisingEdges = 32;  // of a grid line
using RisingEdges = ScratchVector<RisingEdge, kMaxRisingEdges>;
RisingEdges risingEdges(const Sampler& sampler, const GridLine& gridLine,
                        const LinePointParams& params);

// Where the edge is `offset` pixels beside the grid line, followed pixel by pixel.
std::optional<double> edgeBeside(const Sampler& sampler, const GridLine& gridLine,
                                 const RisingEdge& edge, int offset);

// Whether the image is usable on that side of all of the segment.
bool hasBeside(const GridLine& gridLine, const BrightSegment& segment, int offset);
// Where the bright segment goes on `offset` pixels beside the grid line, followed pixel by pixel.
struct Beside {
  double from = 0.0;
  double to = 0.0;
  double middle() const { return 0.5 * (from + to); }
};
std::optional<Beside> segmentBeside(const Sampler& sampler, const GridLine& gridLine,
                                    const BrightSegment& segment, int offset);

}  // namespace kelpie::vision
