// SPDX-License-Identifier: Apache-2.0
#include "vision/Lattice.h"

#include <cmath>

#include "robot/core/Maths.h"

namespace kelpie::vision {
namespace {

constexpr double kUnit = 65536.0;
// A ball is 50 cm away and 30 px across where it is seen 64 px below the horizon; a beacon's top is
// 80 px above it at 60 cm.
constexpr double kFineBelow = 64.0;
constexpr double kFineAbove = 80.0;
constexpr double kInset = 0.01;  // px, so that rounding to 1/65536 stays inside

std::int32_t fixed(double value) { return static_cast<std::int32_t>(std::lround(value * kUnit)); }

struct Stretch {
  double low;
  double high;
};

// The part of u in which from + u * slope lies between the bounds.
Stretch clipped(Stretch u, double from, double slope, double low, double high) {
  if (std::fabs(slope) < 1e-9) return from >= low && from < high ? u : Stretch{1.0, 0.0};
  const double a = (low - from) / slope;
  const double b = (high - from) / slope;
  return {std::max(u.low, std::min(a, b)), std::min(u.high, std::max(a, b))};
}

LevelBox usableBox(const Level& level) {
  LevelBox box{1e9, 1e9, -1e9, -1e9};
  for (const double x : {kUsableLeft * 1.0, kUsableRight * 1.0})
    for (const double y : {kUsableTop * 1.0, kUsableBottom * 1.0}) {
      const LevelPoint p = level.fromImage({x, y});
      box = {std::min(box.left, p.u), std::min(box.top, p.v), std::max(box.right, p.u),
             std::max(box.bottom, p.v)};
    }
  return box;
}

}  // namespace

Lattice::Lattice(const Level& level, double horizon) : level_(level) {
  const LevelBox box = usableBox(level);
  left_ = std::floor(box.left) + 1.5;
  top_ = std::floor(box.top) + 1.5;
  rows_ = static_cast<int>((box.bottom - top_) / kLatticeStep) + 1;
  fineFrom_ =
      static_cast<int>(maths::clamp((horizon - kFineAbove - top_) / kLatticeStep, -1e6, 1e6));
  fineTo_ = static_cast<int>(maths::clamp((horizon + kFineBelow - top_) / kLatticeStep, -1e6, 1e6));
  stepX_ = fixed(kLatticeStep * level.cos);
  stepY_ = fixed(kLatticeStep * level.sin);
}

LatticeRow Lattice::row(int index) const {
  const PixelPoint from = level_.toImage({left_, v(index)});
  Stretch u{0.0, 1e4};
  u = clipped(u, from.x, level_.cos, kUsableLeft + kInset, kUsableRight - kInset);
  u = clipped(u, from.y, level_.sin, kUsableTop + kInset, kUsableBottom - kInset);
  LatticeRow row;
  if (u.low > u.high) return row;
  row.first = static_cast<int>(std::ceil(u.low / kLatticeStep));
  row.count = static_cast<int>(std::floor(u.high / kLatticeStep)) - row.first + 1;
  if (row.count < 0) row.count = 0;
  const double start = kLatticeStep * static_cast<double>(row.first);
  row.x = fixed(from.x + start * level_.cos);
  row.y = fixed(from.y + start * level_.sin);
  return row;
}

}  // namespace kelpie::vision
