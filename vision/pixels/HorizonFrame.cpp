// SPDX-License-Identifier: Apache-2.0
#include "vision/pixels/HorizonFrame.h"

#include <cmath>

#include "robot/core/Maths.h"

namespace kelpie::vision {

HorizonFrame horizonFrameOf(const CameraPose& camera) {
  constexpr double kMaxAbove = 1e4;  // px; a horizon outside the image ends here
  // Axes have length 1; nothing else may pass, NaN neither.
  constexpr double kMinNorm = 1e-6;
  constexpr double kMaxNorm = 2.0;
  const double zx = camera.axes[6];
  const double zy = camera.axes[7];
  const double zf = camera.axes[8] * camera.lens.focalLength;
  const double norm = std::sqrt(zx * zx + zy * zy);
  if (!(norm > kMinNorm && norm < kMaxNorm && std::fabs(zf) < kMaxAbove))
    return {1.0, 0.0, zf > 0.0 ? kMaxAbove : -kMaxAbove, camera.lens};
  return {-zy / norm, zx / norm, maths::clamp(zf / norm, -kMaxAbove, kMaxAbove), camera.lens};
}

}  // namespace kelpie::vision
