// SPDX-License-Identifier: Apache-2.0
#include "vision/pixels/Lattice.h"

#include <cmath>

#include "robot/core/Maths.h"
#include "vision/pixels/FixedPoint.h"

namespace kelpie::vision {
namespace {

// A ball is a metre away and 15 px across where it is seen 32 px below the horizon; where a
// beacon's top is 44 px above it, at a metre, its pink band is 19 px high. Nothing there needs
// every second row: 12000 rendered views (`kelpie evaluate objects`) gave the same figures to their
// noise with 64 and 80 px, which took 2 % more of a frame.
constexpr double kFineBelow = 32.0;
constexpr double kFineAbove = 44.0;
constexpr double kRimMargin = 0.01;  // px, so that rounding to 1/65536 stays inside
// px from the pixel that the usable box begins in to the middle of the next, the first all inside.
constexpr double kToFirstSample = 1.5;
constexpr double kMaxRow = 1e6;    // rows; a horizon far outside still becomes a whole number
constexpr double kMaxAlong = 1e4;  // px along a row, longer than any image

std::int32_t fixed(double value) { return fixedPoint(value, kLatticeOne); }

// Of what is not negative.
int roundedUp(double value) {
  const int whole = static_cast<int>(value);
  return whole < value ? whole + 1 : whole;
}

LevelBox usableBox(const HorizonFrame& frame) {
  LevelBox box = kEmptyLevelBox;
  for (const double x : {kUsableLeft * 1.0, kUsableRight * 1.0})
    for (const double y : {kUsableTop * 1.0, kUsableBottom * 1.0}) {
      const LevelPoint p = frame.fromImage({x, y});
      box = {std::min(box.left, p.u), std::min(box.top, p.v), std::max(box.right, p.u),
             std::max(box.bottom, p.v)};
    }
  return box;
}

}  // namespace

Lattice::Lattice(const HorizonFrame& frame, double horizon) : frame_(frame) {
  const LevelBox box = usableBox(frame);
  left_ = std::floor(box.left) + kToFirstSample;
  top_ = std::floor(box.top) + kToFirstSample;
  rows_ = static_cast<int>((box.bottom - top_) / kLatticeStep) + 1;
  fineFrom_ = static_cast<int>(
      maths::clamp((horizon - kFineAbove - top_) / kLatticeStep, -kMaxRow, kMaxRow));
  fineTo_ = static_cast<int>(
      maths::clamp((horizon + kFineBelow - top_) / kLatticeStep, -kMaxRow, kMaxRow));
  origin_ = frame.toImage({left_, top_});
  across_ = {frame.cos, kUsableLeft + kRimMargin, kUsableRight - kRimMargin};
  along_ = {frame.sin, kUsableTop + kRimMargin, kUsableBottom - kRimMargin};
  stepX_ = fixed(kLatticeStep * frame.cos);
  stepY_ = fixed(kLatticeStep * frame.sin);
}

LatticeRow Lattice::row(int index) const {
  const PixelPoint from = moved(origin_, -frame_.up(), kLatticeStep * index);
  ClippedRange u{0.0, kMaxAlong};
  across_.clip(from.x, u);
  along_.clip(from.y, u);
  LatticeRow row;
  if (u.from > u.to) return row;
  constexpr double kPerStep = 1.0 / kLatticeStep;
  row.first = roundedUp(u.from * kPerStep);
  row.count = static_cast<int>(u.to * kPerStep) - row.first + 1;
  if (row.count < 0) row.count = 0;
  const double start = kLatticeStep * static_cast<double>(row.first);
  row.x = fixed(from.x + start * frame_.cos);
  row.y = fixed(from.y + start * frame_.sin);
  return row;
}

}  // namespace kelpie::vision
