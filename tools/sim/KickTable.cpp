// SPDX-License-Identifier: Apache-2.0
#include "tools/sim/KickTable.h"

#include <cmath>

#include "robot/core/Maths.h"

namespace kelpie::sim {
namespace {

MotionKind leftOf(MotionKind kind) {
  if (kind == MotionKind::headSwipeRight) return MotionKind::headSwipeLeft;
  if (kind == MotionKind::upennRight) return MotionKind::upennLeft;
  return kind;
}

KickCell mirrored(KickCell cell) {
  cell.direction = -cell.direction;
  return cell;
}

// Where a place is among so many of a row: the one before it, the share of the way to the next, and
// how many steps it is outside.
struct Between {
  std::size_t before;
  double share;
  double outside;
};
Between between(double at, double first, double step, std::size_t count) {
  const double last = static_cast<double>(count - 1);
  const double place = (at - first) / step;
  const double inside = maths::clamp(place, 0.0, last);
  const double before = std::fmin(std::floor(inside), last - 1.0);
  return {static_cast<std::size_t>(before), inside - before, std::fabs(place - inside)};
}

void add(const KickCell& cell, double weight, KickCell& sum) {
  const double went = weight * cell.chance;
  sum.chance += went;
  sum.direction += went * cell.direction;
  sum.sd += went * cell.sd;
  sum.distance += went * cell.distance;
  sum.reachSd += went * cell.reachSd;
}

KickCell at(const KickGrid& grid, double right, double ahead) {
  const Between column = between(right, grid.leftmost, grid.aside, grid.columns);
  const Between row = between(ahead, grid.nearest, grid.ahead, grid.rows);
  KickCell sum{};
  for (std::size_t i = 0; i < 2; ++i) {
    for (std::size_t j = 0; j < 2; ++j) {
      const double down = i == 1 ? row.share : 1.0 - row.share;
      const double across = j == 1 ? column.share : 1.0 - column.share;
      add(grid.cells[(row.before + i) * grid.columns + column.before + j], down * across, sum);
    }
  }
  if (sum.chance <= 0.0) return {};
  const double inside = std::fmax(0.0, 1.0 - std::hypot(column.outside, row.outside));
  const double each = 1.0 / sum.chance;
  return {inside * sum.chance, each * sum.direction, each * sum.sd, each * sum.distance,
          each * sum.reachSd};
}

}  // namespace

std::optional<KickCell> freeKick(MotionKind kind, bool walks, Point2<Robot> ball) {
  const MotionKind left = leftOf(kind);
  for (const KickGrid& grid : kickGrids()) {
    if (grid.kind != left || grid.walks != walks) continue;
    const bool own = grid.leftmost == 0.0;  // its own mirror image
    const bool other = own ? ball.x < 0.0 : kind != left;
    const KickCell cell = at(grid, other ? -ball.x : ball.x, ball.y);
    return other ? mirrored(cell) : cell;
  }
  return std::nullopt;
}

std::optional<KickCell> heldKick(MotionKind kind) {
  const MotionKind left = leftOf(kind);
  for (const HeldKick& row : heldKicks())
    if (row.kind == left) return kind == left ? row.cell : mirrored(row.cell);
  return std::nullopt;
}

}  // namespace kelpie::sim
