// SPDX-License-Identifier: Apache-2.0
#include "gps/players/ObstacleMap.h"

#include <algorithm>
#include <cmath>

#include "robot/core/Maths.h"
#include "robot/core/ScratchVector.h"

namespace kelpie::gps {
namespace {

constexpr float kMinCount = 0.1F;   // of a point
constexpr double kBodyReach = 8.0;  // cm from a robot's middle to where it counts as well

using Layer = std::array<float, kMapCells>;

// Keeps the list of occupied cells in order: behaviours and team get them in that order.
void set(Layer ObstacleMap::*layer, std::size_t cell, float count, ObstacleMap& map) {
  const bool empty = map.own[cell] == 0.0F && map.heard[cell] == 0.0F;
  (map.*layer)[cell] = count;
  if (!empty || count == 0.0F) return;
  const auto number = static_cast<std::uint16_t>(cell);
  auto* at = std::lower_bound(map.occupied.begin(), map.occupied.end(), number);
  map.occupied.push_back(number);
  std::copy_backward(at, map.occupied.end() - 1, map.occupied.end());
  *at = number;
}

void enter(Point2<Field> p, double count, const body::FieldDescription& field, double max,
           ObstacleMap& map) {
  const auto cell = cellAt(p, field);
  if (!cell) return;
  const double sum = static_cast<double>(map.own[*cell]) + count;
  set(&ObstacleMap::own, *cell, static_cast<float>(std::min(max, sum)), map);
}

using Cells = ScratchVector<std::size_t, 64>;  // as many as there are points

Cells enterPoints(const ObstacleSightings& in, const body::FieldDescription& field,
                  const ObstacleMapParams& params, ObstacleMap& map) {
  Cells cells;
  for (const ObstaclePoint& point : in.percepts.obstacles) {
    const double away = point.position.norm();
    if (!(away >= params.minReach && away <= params.maxReach)) continue;
    const Point2<Field> p = fieldFromRobot(in.world.pose, point.position);
    enter(p, 1.0, field, params.maxCount, map);
    if (const auto cell = cellAt(p, field)) cells.push_back(*cell);
  }
  return cells;
}

void enterRobots(const ObstacleSightings& in, const body::FieldDescription& field,
                 const ObstacleMapParams& params, ObstacleMap& map) {
  for (const RobotPercept& robot : in.percepts.robots) {
    if (!(robot.distance <= params.maxReach)) continue;
    const Point2<Robot> seen = robotPolar(robot.distance, robot.heading);
    const Point2<Field> p = fieldFromRobot(in.world.pose, seen);
    for (const Point2<Field>& lateral :
         {Point2<Field>{0, 0}, Point2<Field>{kBodyReach, 0}, Point2<Field>{-kBodyReach, 0},
          Point2<Field>{0, kBodyReach}, Point2<Field>{0, -kBodyReach}}) {
      enter(p + lateral, params.robotCount, field, params.maxCount, map);
    }
  }
}

void clear(const ObstacleSightings& in, const Cells& seen, const body::FieldDescription& field,
           const ObstacleMapParams& params, ObstacleMap& map) {
  for (const LinePoint& point : in.percepts.linePoints) {
    if (!(point.position.norm() <= params.clearReach)) continue;
    const auto cell = cellAt(fieldFromRobot(in.world.pose, point.position), field);
    if (!cell || std::find(seen.begin(), seen.end(), *cell) != seen.end()) continue;
    map.own[*cell] *= static_cast<float>(params.clearShare);
  }
}

// As many of these cells as the list takes, the fuller ones, in order.
template <class Listed>
ScratchVector<std::uint16_t, kMapCells> fullestOf(const ObstacleMap& map, const Listed& listed) {
  ScratchVector<std::uint16_t, kMapCells> full;
  for (const std::uint16_t cell : map.occupied)
    if (listed(cell)) full.push_back(cell);
  const auto fuller = [&map](std::uint16_t a, std::uint16_t b) {
    return map.count(a) > map.count(b) || (map.count(a) == map.count(b) && a < b);
  };
  std::nth_element(full.begin(), full.begin() + kObstacleCells, full.end(), fuller);
  full.resize(kObstacleCells);
  std::sort(full.begin(), full.end());
  return full;
}

float faded(float count, float share) { return count * share < kMinCount ? 0.0F : count * share; }

}  // namespace

std::optional<std::size_t> cellAt(Point2<Field> p, const body::FieldDescription& field) {
  const double column = (p.x + field.sideFringe) / kObstacleCell;
  const double row = (p.y + field.endFringe) / kObstacleCell;
  if (!(column >= 0.0 && column < kMapColumns && row >= 0.0 && row < kMapRows)) return std::nullopt;
  return static_cast<std::size_t>(row) * kMapColumns + static_cast<std::size_t>(column);
}

Point2<Field> middleOf(std::size_t cell, const body::FieldDescription& field) {
  const std::size_t row = cell / kMapColumns;
  const std::size_t column = cell - row * kMapColumns;
  return {(static_cast<double>(column) + 0.5) * kObstacleCell - field.sideFringe,
          (static_cast<double>(row) + 0.5) * kObstacleCell - field.endFringe};
}

void forget(double elapsed, const ObstacleMapParams& params, ObstacleMap& map) {
  const auto ownShare = static_cast<float>(maths::exp(-params.forgetRate * elapsed));
  const auto heardShare = static_cast<float>(maths::exp(-params.forgetHeardRate * elapsed));
  std::size_t left = 0;
  for (const std::uint16_t cell : map.occupied) {
    map.own[cell] = faded(map.own[cell], ownShare);
    map.heard[cell] = faded(map.heard[cell], heardShare);
    if (map.own[cell] != 0.0F || map.heard[cell] != 0.0F) map.occupied[left++] = cell;
  }
  map.occupied.resize(left);
}

void see(const ObstacleSightings& in, const body::FieldDescription& field,
         const ObstacleMapParams& params, ObstacleMap& map) {
  const bool sure = in.world.positionSd <= params.maxPositionSd &&
                    in.world.headingSd.rad() <= params.maxHeadingSd.rad();
  if (!sure) return;
  const Cells cells = enterPoints(in, field, params, map);
  enterRobots(in, field, params, map);
  clear(in, cells, field, params, map);
}

void hear(const TeamMessage& message, const body::FieldDescription& field,
          const ObstacleMapParams& params, ObstacleMap& map) {
  for (const SharedObstacle& reported : message.obstacles) {
    const auto cell = cellAt(reported.position, field);
    if (!cell) continue;
    const auto count = static_cast<float>(std::min(reported.count, params.maxCount));
    set(&ObstacleMap::heard, *cell, std::max(map.heard[*cell], count), map);
  }
}

FixedVector<SharedObstacle, kSharedObstacles> fullest(const ObstacleMap& map,
                                                      const body::FieldDescription& field,
                                                      const ObstacleMapParams& params) {
  FixedVector<SharedObstacle, kSharedObstacles> list;
  for (const std::uint16_t cell : map.occupied) {
    const auto count = static_cast<double>(map.own[cell]);
    if (count < params.tellCount) continue;
    SharedObstacle item{middleOf(cell, field), count};
    for (SharedObstacle& kept : list)
      if (item.count > kept.count) std::swap(item, kept);
    list.push_back(item);  // nothing when it is full
  }
  return list;
}

void list(const ObstacleMap& map, const body::FieldDescription& field, ObstacleCells& cells) {
  constexpr double kMinListed = 1.0;  // point
  cells.clear();
  const auto listed = [&map](std::uint16_t cell) { return map.count(cell) >= kMinListed; };
  const auto add = [&](std::uint16_t cell) {
    cells.push_back({middleOf(cell, field), static_cast<double>(map.own[cell]),
                     static_cast<double>(map.heard[cell])});
  };
  const auto count = std::count_if(map.occupied.begin(), map.occupied.end(), listed);
  if (count > static_cast<std::ptrdiff_t>(kObstacleCells)) {
    for (const std::uint16_t cell : fullestOf(map, listed)) add(cell);
    return;
  }
  for (const std::uint16_t cell : map.occupied)
    if (listed(cell)) add(cell);
}

ObstacleCells listed(const ObstacleMap& map, const body::FieldDescription& field) {
  ObstacleCells cells;
  list(map, field, cells);
  return cells;
}

}  // namespace kelpie::gps
