// SPDX-License-Identifier: Apache-2.0
// Where something stands on the field: squares of 10 cm that count the dark and grey points and the
// robots seen in them (facts-2005 section 4.7, thesis 2006 section 6.4.4), forget them, and are
// emptied where carpet is seen. What mates say is kept apart, so that no robot hears its own
// report. The map lies on the field: a robot that is wrong about its place writes beside the truth,
// so one that is unsure writes nothing.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "gps/players/ObstacleMapParams.h"
#include "robot/body/FieldDescription.h"
#include "robot/core/types/ObstacleCells.h"
#include "robot/core/types/Percepts.h"
#include "robot/core/types/TeamMessage.h"
#include "robot/core/types/WorldModel.h"

namespace kelpie::gps {

constexpr double kObstacleCell = 10.0;  // cm
// From the carpet's corner: 480 x 640 cm; what is farther on a larger field is not mapped.
constexpr std::size_t kMapColumns = 48;
constexpr std::size_t kMapRows = 64;
constexpr std::size_t kMapCells = kMapColumns * kMapRows;

struct ObstacleMap {
  std::array<float, kMapCells> own{};
  std::array<float, kMapCells> heard{};
  // The cells that hold anything, ascending: seldom a tenth of all, and only they cost time.
  FixedVector<std::uint16_t, kMapCells> occupied;

  double count(std::size_t cell) const { return static_cast<double>(own[cell] + heard[cell]); }
};

std::optional<std::size_t> cellAt(Point2<Field> p, const body::FieldDescription& field);
Point2<Field> middleOf(std::size_t cell, const body::FieldDescription& field);

void forget(double elapsed, const ObstacleMapParams& params, ObstacleMap& map);

struct ObstacleSightings {
  const Percepts& percepts;
  const WorldModel& world;  // the pose and how sure it is
};

// Enters this frame's points and robots and empties cells in which carpet is seen.
void see(const ObstacleSightings& in, const body::FieldDescription& field,
         const ObstacleMapParams& params, ObstacleMap& map);

// A mate tells counts, not new points: the larger count stays.
void hear(const TeamMessage& message, const body::FieldDescription& field,
          const ObstacleMapParams& params, ObstacleMap& map);

// For the team: the fullest of the own cells, fullest first.
FixedVector<SharedObstacle, kSharedObstacles> fullest(const ObstacleMap& map,
                                                      const body::FieldDescription& field,
                                                      const ObstacleMapParams& params);

// For the behaviours: all cells that hold a point or more, of more than the list takes the fuller.
void list(const ObstacleMap& map, const body::FieldDescription& field, ObstacleCells& cells);
ObstacleCells listed(const ObstacleMap& map, const body::FieldDescription& field);

}  // namespace kelpie::gps
