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

  // Keeps the ways at which low <= start + way * slope < high.
  void clip(double start, double slope, double low, double high) {
    if (std::fabs(slope) < 1e-9) {
      if (start < low || start >= high) to = from - 1.0;
      return;
    }
    const double a = (low - start) / slope;
    const double b = (high - start) / slope;
    from = std::max(from, std::min(a, b));
    to = std::min(to, std::max(a, b));
  }
};

}  // namespace kelpie::vision
