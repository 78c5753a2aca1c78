// SPDX-License-Identifier: Apache-2.0
// The pixels that are looked at in every image: a lattice in level coordinates (HorizonFrame.h),
// its rows parallel to the horizon. Every second pixel both ways: the pink band of a beacon at 400
// cm is 4.8 px wide and high, a ball at 350 cm 4.6 px across, so that each holds two by two
// samples. Far from the horizon only near things are seen: there every second row is left out.
#pragma once

#include <cstdint>

#include "vision/pixels/ClippedRange.h"
#include "vision/pixels/FixedPoint.h"
#include "vision/pixels/HorizonFrame.h"
#include "vision/pixels/Sampler.h"

namespace kelpie::vision {

constexpr int kLatticeStep = 2;

// The samples of one lattice row that lie in the usable image. Positions are in 1/65536 px.
struct LatticeRow {
  std::int32_t x = 0;
  std::int32_t y = 0;
  int first = 0;  // lattice column of the first sample
  int count = 0;

  int pixelX() const { return x >> kLatticeBits; }
  int pixelY() const { return y >> kLatticeBits; }
};

class Lattice {
 public:
  // `horizon`: level row of the horizon at the image's middle.
  explicit Lattice(const HorizonFrame& frame, double horizon = body::kNominalLens.principalY);

  int rows() const { return rows_; }
  // Rows that this one stands for: itself, and the next one where that is left out.
  int height(int row) const { return row >= fineFrom_ && row < fineTo_ ? 1 : 2; }
  LatticeRow row(int index) const;
  std::int32_t stepX() const { return stepX_; }
  std::int32_t stepY() const { return stepY_; }
  double u(double column) const { return left_ + kLatticeStep * column; }
  double v(double row) const { return top_ + kLatticeStep * row; }
  const HorizonFrame& frame() const { return frame_; }

 private:
  HorizonFrame frame_;
  double left_ = 0.0;  // u of column 0
  double top_ = 0.0;   // v of row 0
  PixelPoint origin_;  // of row 0 and column 0
  WalkBounds across_;  // of a row's walk along x,
  WalkBounds along_;   // and y
  int rows_ = 0;
  int fineFrom_ = 0;
  int fineTo_ = 0;
  std::int32_t stepX_ = 0;
  std::int32_t stepY_ = 0;
};

}  // namespace kelpie::vision
