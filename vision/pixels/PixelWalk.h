// SPDX-License-Identifier: Apache-2.0
// The pixels at whole steps of a straight walk through the image, in whole numbers: no step needs a
// number converted. Off by 2e-4 px after the image's diagonal; wrong where the walk begins 1000 px
// outside.
#pragma once

#include <cstdint>

#include "robot/core/types/Geometry.h"
#include "vision/pixels/FixedPoint.h"
#include "vision/pixels/HorizonFrame.h"

namespace kelpie::vision {

class PixelWalk {
 public:
  PixelWalk() = default;
  PixelWalk(PixelPoint from, ImageDirection direction)
      : x_(fixed(from.x)),
        y_(fixed(from.y)),
        stepX_(fixed(direction.dx)),
        stepY_(fixed(direction.dy)) {}

  int x(int step) const { return (x_ + step * stepX_) >> kBits; }
  int y(int step) const { return (y_ + step * stepY_) >> kBits; }

 private:
  static constexpr int kBits = 20;
  static std::int32_t fixed(double value) { return fixedPoint(value, 1 << kBits); }

  std::int32_t x_ = 0;
  std::int32_t y_ = 0;
  std::int32_t stepX_ = 0;
  std::int32_t stepY_ = 0;
};

}  // namespace kelpie::vision
