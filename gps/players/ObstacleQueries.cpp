// SPDX-License-Identifier: Apache-2.0
#include "gps/players/ObstacleQueries.h"

#include <algorithm>
#include <cmath>

#include "robot/core/Maths.h"

namespace kelpie::gps {
namespace {

constexpr double kSectorWidth = 2.0 * maths::kPi / kObstacleSectors;

double awayFromWay(Point2<Field> p, Point2<Field> from, Point2<Field> to) {
  const Point2<Field> way = to - from;
  const double length2 = way.x * way.x + way.y * way.y;
  const Point2<Field> there = p - from;
  const double along = length2 > 0.0 ? (there.x * way.x + there.y * way.y) / length2 : 0.0;
  const double share = maths::clamp(along, 0.0, 1.0);
  return maths::hypot(there.x - share * way.x, there.y - share * way.y);
}

std::size_t sectorOf(Angle heading) {
  const double turns = std::floor(heading.rad() / kSectorWidth + 0.5);
  const int index = static_cast<int>(turns) + static_cast<int>(kObstacleSectors);
  return static_cast<std::size_t>(index) % kObstacleSectors;
}

Angle headingOf(int sector) { return Angle::rad(kSectorWidth * sector); }

// A run of free sectors by signed index, ahead is 0 and left is positive.
struct Run {
  int first = 0;
  int last = -1;
};

bool isFree(const Sectors& sectors, int index, const ObstacleMapParams& params) {
  constexpr int kAll = static_cast<int>(kObstacleSectors);
  return sectors[static_cast<std::size_t>((index + kAll) % kAll)].nearest > params.gapReach;
}

// The direction of a run nearest to the desired one.
ObstacleGap gapOf(const Run& run, Angle desired, const ObstacleMapParams& params) {
  const double half = 0.5 * kSectorWidth;
  const double right = kSectorWidth * run.first - half;
  const double left = kSectorWidth * run.last + half;
  if (left - right < params.gapWidth.rad()) return {};
  const double margin = 0.5 * params.gapWidth.rad();
  const double heading = maths::clamp(desired.rad(), right + margin, left - margin);
  return {true, Angle::rad(heading), Angle::rad(std::min(left - right, maths::kPi))};
}

}  // namespace

double countInCorridor(const ObstacleView& view, Point2<Field> from, Point2<Field> to) {
  double sum = 0.0;
  for (std::size_t cell = 0; cell < kMapCells; ++cell) {
    const double count = view.map.count(cell);
    if (count <= 0.0) continue;
    const double away = awayFromWay(middleOf(cell, view.field), from, to);
    if (away <= 0.5 * view.params.corridorWidth) sum += count;
  }
  return sum;
}

Sectors sectorsAround(const ObstacleView& view, const Pose2& robot) {
  Sectors sectors{};
  for (std::size_t cell = 0; cell < kMapCells; ++cell) {
    const double count = view.map.count(cell);
    if (count <= 0.0) continue;
    const Point2<Robot> p = robotFromField(robot, middleOf(cell, view.field));
    const double away = p.norm();
    if (away > view.params.sectorReach || away < view.params.minReach) continue;
    ObstacleSector& sector = sectors[sectorOf(bearing(p))];
    sector.count += count;
    if (count >= view.params.fullCount) sector.nearest = std::min(sector.nearest, away);
  }
  return sectors;
}

double countInSector(const Sectors& sectors, Angle heading, Angle width) {
  double sum = 0.0;
  for (std::size_t i = 0; i < kObstacleSectors; ++i) {
    const Angle away = headingOf(static_cast<int>(i)) - heading;
    if (std::fabs(away.rad()) <= 0.5 * width.rad()) sum += sectors[i].count;
  }
  return sum;
}

ObstacleGap bestGap(const Sectors& sectors, Angle desired, const ObstacleMapParams& params) {
  const int most = static_cast<int>(params.gapAside.rad() / kSectorWidth);
  ObstacleGap best;
  Run run;
  bool open = false;
  for (int i = -most; i <= most + 1; ++i) {
    const bool free = i <= most && isFree(sectors, i, params);
    if (free) {
      run = {open ? run.first : i, i};
    } else if (open) {
      const ObstacleGap gap = gapOf(run, desired, params);
      const auto off = [desired](const ObstacleGap& g) {
        return std::fabs((g.heading - desired).rad());
      };
      if (gap.present && (!best.present || off(gap) < off(best))) best = gap;
    }
    open = free;
  }
  return best;
}

ObstacleEstimate extractObstacles(const ObstacleView& view, const WorldModel& world) {
  const Point2<Field> goal{0.5 * view.field.width, view.field.length};
  const Point2<Field> me = world.pose.position;
  ObstacleEstimate estimate;
  estimate.sectors = sectorsAround(view, world.pose);
  if (world.ball.present) estimate.toBall = countInCorridor(view, me, world.ball.position);
  estimate.toGoal = countInCorridor(view, world.ball.present ? world.ball.position : me, goal);
  const Angle desired = bearing(robotFromField(world.pose, goal));
  estimate.gapToGoal = bestGap(estimate.sectors, desired, view.params);
  estimate.cells = fullest(view.map, view.field, view.params);
  return estimate;
}

}  // namespace kelpie::gps
