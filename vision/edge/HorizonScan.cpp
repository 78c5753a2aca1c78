// SPDX-License-Identifier: Apache-2.0
#include "vision/edge/HorizonScan.h"

#include <algorithm>
#include <cmath>

#include "vision/pixels/ClippedRange.h"

namespace kelpie::vision {
namespace {

// The middle scan line of a level image runs through the centres of a lattice column.
constexpr PixelPoint kMiddle{kImageWidth / 2.0 + 0.5, kImageHeight / 2.0 + 0.5};

// Within a thousandth of the rim a step could round to the unusable pixel beyond.
constexpr double kRimMargin = 1e-3;

ClippedRange insideImage(PixelPoint start, ImageDirection down) {
  constexpr double kUnlimited = 1e4;  // px
  ClippedRange range{-kUnlimited, kUnlimited};
  range.clip(start.x, down.dx, kUsableLeft + kRimMargin, kUsableRight - kRimMargin);
  range.clip(start.y, down.dy, kUsableTop + kRimMargin, kUsableBottom - kRimMargin);
  return range;
}

}  // namespace

ScanLines horizonScan(const HorizonFrame& frame, const HorizonScanParams& params) {
  ScanLines lines;
  constexpr int kHalf = static_cast<int>(kMaxScanLines) / 2;
  const double highest = frame.above(kMiddle) - params.aboveHorizon;
  const double densest = frame.above(kMiddle) + params.denseDepth;
  const ImageDirection down = -frame.up();
  for (int k = -kHalf; k < kHalf; ++k) {
    const PixelPoint start = moved(kMiddle, frame.right(), k * kHorizonScanSpacing);
    ClippedRange range = insideImage(start, down);
    const bool cutTop = highest < range.from;
    range.from = std::max(range.from, highest);
    if (k % 2 != 0) range.to = std::min(range.to, densest);
    // Steps at the same depths on all lines: in a level image they meet the lattice.
    const double first = 2.0 * std::ceil(0.5 * range.from);
    const double last = std::floor(range.to);
    if (!(last > first)) continue;
    lines.push_back({moved(start, down, first), down, static_cast<int>(last - first) + 1, cutTop});
  }
  return lines;
}

}  // namespace kelpie::vision
