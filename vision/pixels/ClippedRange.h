// SPDX-License-Identifier: Apache-2.0
// The part of a straight walk through the image in which its coordinates keep within bounds.
#pragma once

#include <algorithm>
#include <cmath>

namespace kelpie::vision {

// Ways along the walk; empty when `to` is below `from`.
struct ClippedRange {
  double from = 0.0;
  double to = 0.0;
};

// The bounds of one coordinate, for all walks of one direction: 150 of them in each image would
// divide by the same slope.
class WalkBounds {
 public:
  WalkBounds() = default;
  // `slope`: of the coordinate along the walk.
  WalkBounds(double slope, double low, double high)
      : low_(low), high_(high), perSlope_(std::fabs(slope) < kMinSlope ? 0.0 : 1.0 / slope) {}

  // Keeps the ways at which low <= start + way * slope < high.
  void clip(double start, ClippedRange& range) const {
    if (perSlope_ == 0.0) {
      if (start < low_ || start >= high_) range.to = range.from - 1.0;
      return;
    }
    const double a = (low_ - start) * perSlope_;
    const double b = (high_ - start) * perSlope_;
    range.from = std::max(range.from, std::min(a, b));
    range.to = std::min(range.to, std::max(a, b));
  }

 private:
  static constexpr double kMinSlope = 1e-9;  // below it the coordinate stays the same

  double low_ = 0.0;
  double high_ = 0.0;
  double perSlope_ = 0.0;  // 0: the coordinate stays the same
};

}  // namespace kelpie::vision
