// SPDX-License-Identifier: Apache-2.0
#include "tools/sim/kicks/KickMap.h"

#include <optional>

#include "actuator/MotionList.h"

namespace kelpie::sim {
namespace {

// Where a number lies among rising ones: after which, and how far to the next.
struct Between {
  std::size_t index = 0;
  double share = 0.0;
};
std::optional<Between> between(const std::vector<double>& places, double at) {
  if (at < places.front() || at > places.back()) return std::nullopt;
  std::size_t index = 0;
  while (index + 2 < places.size() && places[index + 1] <= at) ++index;
  if (places.size() == 1) return Between{};
  return Between{index, (at - places[index]) / (places[index + 1] - places[index])};
}

}  // namespace

MotionKind mirrored(MotionKind motion) { return actuator::listed(motion).mirror; }

KickCell cellAt(const KickGrid& grid, Point2<Robot> place) {
  const bool swapped = isItsOwnMirror(grid.motion) && place.x < 0.0;
  const auto column = between(grid.lateral, swapped ? -place.x : place.x);
  const auto row = between(grid.ahead, place.y);
  KickCell mean;
  if (!column || !row) return mean;
  double direction = 0.0;
  double directionSd = 0.0;
  for (const std::size_t r : {0U, 1U})
    for (const std::size_t c : {0U, 1U}) {
      const double weight =
          (r == 0 ? 1.0 - row->share : row->share) * (c == 0 ? 1.0 - column->share : column->share);
      if (weight <= 0.0) continue;
      const KickCell& cell = grid.cell(row->index + r, column->index + c);
      if (cell.runs == 0) return {};
      const double goes = weight * cell.went;
      mean.runs += cell.runs;
      mean.went += goes;
      mean.fell += weight * cell.fell;
      direction += goes * cell.direction.rad();
      directionSd += goes * cell.directionSd.rad();
      mean.distance += goes * cell.distance;
      mean.distanceSd += goes * cell.distanceSd;
    }
  if (mean.went <= 0.0) return mean;
  mean.direction = Angle::rad((swapped ? -1.0 : 1.0) * direction / mean.went);
  mean.directionSd = Angle::rad(directionSd / mean.went);
  mean.distance /= mean.went;
  mean.distanceSd /= mean.went;
  return mean;
}

}  // namespace kelpie::sim
