// SPDX-License-Identifier: Apache-2.0
#include "vision/ScanLines.h"

#include <algorithm>
#include <cmath>

#include "robot/body/Camera.h"
#include "robot/core/Maths.h"

namespace kelpie::vision {
namespace {

constexpr double kFar = 1e4;  // px; a horizon outside the image ends here
// The middle scan line of a level image runs through the centres of a lattice column.
constexpr PixelPoint kMiddle{kImageWidth / 2.0 + 0.5, kImageHeight / 2.0 + 0.5};

struct Stretch {
  double from = -kFar;
  double to = kFar;
};

// Cuts the stretch of a walk start + t * direction to low <= coordinate < high.
void cut(Stretch& stretch, double start, double direction, double low, double high) {
  if (std::fabs(direction) < 1e-9) {
    if (start < low || start >= high) stretch.to = stretch.from - 1.0;
    return;
  }
  const double a = (low - start) / direction;
  const double b = (high - start) / direction;
  stretch.from = std::max(stretch.from, std::min(a, b));
  stretch.to = std::min(stretch.to, std::max(a, b));
}

// Within a thousandth of the rim a step could round to the unusable pixel beyond.
constexpr double kInside = 1e-3;

Stretch insideImage(PixelPoint start, double downX, double downY) {
  Stretch stretch;
  cut(stretch, start.x, downX, kUsableLeft + kInside, kUsableRight - kInside);
  cut(stretch, start.y, downY, kUsableTop + kInside, kUsableBottom - kInside);
  return stretch;
}

}  // namespace

ImageLevel imageLevel(const CameraPose& camera) {
  const double zx = camera.axes[6];
  const double zy = camera.axes[7];
  const double zf = camera.axes[8] * body::kFocalLength;
  const double norm = std::sqrt(zx * zx + zy * zy);
  // Axes have length 1; nothing else may pass, were it no number.
  if (!(norm > 1e-6 && norm < 2.0 && std::fabs(zf) < kFar))
    return {0.0, -1.0, zf > 0.0 ? kFar : -kFar};
  return {zx / norm, zy / norm, maths::clamp(zf / norm, -kFar, kFar)};
}

ScanLines scanLines(const ImageLevel& level, const ScanParams& params) {
  ScanLines lines;
  constexpr int kHalf = static_cast<int>(kMaxScanLines) / 2;
  const double highest = level.aboveHorizon(kMiddle) - params.aboveHorizon;
  const double densest = level.aboveHorizon(kMiddle) + params.denseDepth;
  for (int k = -kHalf; k < kHalf; ++k) {
    // Rightwards along the horizon is up turned clockwise.
    const double along = k * kScanSpacing;
    const PixelPoint start{kMiddle.x - along * level.upY, kMiddle.y + along * level.upX};
    Stretch stretch = insideImage(start, -level.upX, -level.upY);
    const bool cutTop = highest < stretch.from;
    stretch.from = std::max(stretch.from, highest);
    if (k % 2 != 0) stretch.to = std::min(stretch.to, densest);
    // Steps at the same depths on all lines: in a level image they meet the lattice.
    const double first = 2.0 * std::ceil(0.5 * stretch.from);
    const double last = std::floor(stretch.to);
    if (!(last > first)) continue;
    lines.push_back({{start.x - first * level.upX, start.y - first * level.upY},
                     -level.upX,
                     -level.upY,
                     static_cast<int>(last - first) + 1,
                     cutTop});
  }
  return lines;
}

}  // namespace kelpie::vision
