// SPDX-License-Identifier: Apache-2.0
#include "vision/edge/HorizonScan.h"

#include <algorithm>
#include <cmath>

#include "vision/pixels/ClippedRange.h"

namespace kelpie::vision {
namespace {

// The sample of the lattice next to the image's middle.
PixelPoint middleOf(const Lattice& lattice) {
  constexpr PixelPoint kMiddle{kImageWidth / 2.0 + 0.5, kImageHeight / 2.0 + 0.5};
  const HorizonFrame& frame = lattice.frame();
  const LevelPoint level = frame.fromImage(kMiddle);
  const auto nearest = [](double way) { return std::floor(way / kLatticeStep + 0.5); };
  return frame.toImage(
      {lattice.u(nearest(level.u - lattice.u(0))), lattice.v(nearest(level.v - lattice.v(0)))});
}

// Within a thousandth of the rim a step could round to the unusable pixel beyond (PixelWalk.h).
constexpr double kRimMargin = 1e-3;

class InsideImage {
 public:
  explicit InsideImage(ImageDirection down)
      : x_(down.dx, kUsableLeft + kRimMargin, kUsableRight - kRimMargin),
        y_(down.dy, kUsableTop + kRimMargin, kUsableBottom - kRimMargin) {}
  ClippedRange operator()(PixelPoint start) const {
    constexpr double kUnlimited = 1e4;  // px
    ClippedRange range{-kUnlimited, kUnlimited};
    x_.clip(start.x, range);
    y_.clip(start.y, range);
    return range;
  }

 private:
  WalkBounds x_;
  WalkBounds y_;
};

}  // namespace

ScanLines horizonScan(const Lattice& lattice, const HorizonScanParams& params) {
  ScanLines lines;
  const HorizonFrame& frame = lattice.frame();
  const PixelPoint middle = middleOf(lattice);
  constexpr int kHalf = static_cast<int>(kMaxScanLines) / 2;
  const double highest = frame.above(middle) - params.aboveHorizon;
  const double densest = frame.above(middle) + params.denseDepth;
  const ImageDirection down = -frame.up();
  const InsideImage insideImage(down);
  for (int k = -kHalf; k < kHalf; ++k) {
    const PixelPoint start = moved(middle, frame.right(), k * kHorizonScanSpacing);
    ClippedRange range = insideImage(start);
    const bool cutTop = highest < range.from;
    range.from = std::max(range.from, highest);
    if (k % 2 != 0) range.to = std::min(range.to, densest);
    // Steps at the same depths on all lines, those of the lattice's rows.
    const double first = 2.0 * std::ceil(0.5 * range.from);
    const double last = std::floor(range.to);
    if (!(last > first)) continue;
    lines.push_back({moved(start, down, first), down, static_cast<int>(last - first) + 1, cutTop});
  }
  return lines;
}

}  // namespace kelpie::vision
