// SPDX-License-Identifier: Apache-2.0
#include "tools/sim/kicks/KickTable.h"

#include <cmath>

#include "robot/core/Maths.h"

namespace kelpie::sim {
namespace {

// The nearest of evenly spaced places, or between them, and how many steps from there.
struct Nearest {
  double at;
  double outside;
};
Nearest nearest(const std::vector<double>& places, double min, double at) {
  const double inside = maths::clamp(at, min, places.back());
  return {inside, std::fabs(at - inside) / (places[1] - places[0])};
}

// What is left of a spread without that variance: half of it at least [chosen], as the variance is
// of differences of what was measured.
double without(double variance, double spread) {
  return std::sqrt(std::fmax(spread * spread - variance, 0.25 * spread * spread));
}

// The map's balls lay up to half a step beside their place, which spread them too. Of a ball whose
// place is known that part is taken away again.
KickCell ofKnownPlace(const KickGrid& grid, Point2<Robot> at) {
  constexpr double kEvenly = 1.0 / 12.0;  // variance of what is evenly spread over a width of 1
  const Point2<Robot> right{0.5 * (grid.lateral[1] - grid.lateral[0]), 0.0};
  const Point2<Robot> ahead{0.0, 0.5 * (grid.ahead[1] - grid.ahead[0])};
  double directions = 0.0;
  double distances = 0.0;
  for (const Point2<Robot>& half : {right, ahead}) {
    const KickCell here = cellAt(grid, at - half);
    const KickCell there = cellAt(grid, at + half);
    if (here.went <= 0.0 || there.went <= 0.0) continue;
    directions += kEvenly * maths::square((there.direction - here.direction).rad());
    distances += kEvenly * maths::square(there.distance - here.distance);
  }
  KickCell cell = cellAt(grid, at);
  cell.directionSd = Angle::rad(without(directions, cell.directionSd.rad()));
  cell.distanceSd = without(distances, cell.distanceSd);
  return cell;
}

KickCell fadingAt(const KickGrid& grid, Point2<Robot> ball) {
  const double leftmost = isItsOwnMirror(grid.motion) ? -grid.lateral.back() : grid.lateral.front();
  const Nearest lateral = nearest(grid.lateral, leftmost, ball.x);
  const Nearest ahead = nearest(grid.ahead, grid.ahead.front(), ball.y);
  KickCell cell = ofKnownPlace(grid, {lateral.at, ahead.at});
  cell.went *= std::fmax(0.0, 1.0 - maths::hypot(lateral.outside, ahead.outside));
  return cell;
}

// The map has the left kick of a pair.
std::optional<KickCell> kickOf(MotionKind kind, KickFrom from, Point2<Robot> ball) {
  for (const KickGrid& grid : standardKickMap()) {
    const bool right = grid.motion != kind && mirrored(grid.motion) == kind;
    if (grid.from != from || (grid.motion != kind && !right)) continue;
    if (right) ball.x = -ball.x;
    KickCell cell = from == KickFrom::hold ? grid.window.whole : fadingAt(grid, ball);
    if (right) cell.direction = -cell.direction;
    return cell;
  }
  return std::nullopt;
}

}  // namespace

const KickMap& standardKickMap() {
  // tests/sim/KickTableTest.cpp reads the same text.
  static const KickMap map = *readKickMap(standardKickMapText());
  return map;
}

std::optional<KickCell> freeKick(MotionKind kind, bool walks, Point2<Robot> ball) {
  return kickOf(kind, walks ? KickFrom::walking : KickFrom::standing, ball);
}

std::optional<KickCell> heldKick(MotionKind kind) { return kickOf(kind, KickFrom::hold, {}); }

}  // namespace kelpie::sim
