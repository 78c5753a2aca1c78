// SPDX-License-Identifier: Apache-2.0
// What a robot believes to stand on the field, whatever it is, as answers to the questions of a
// behaviour; part of WorldModel.h. Counts are of points seen, less what was forgotten since.
#pragma once

#include <array>
#include <cstdint>

#include "robot/core/FixedVector.h"
#include "robot/core/Geometry.h"

namespace kelpie {

constexpr std::size_t kObstacleSectors = 36;
constexpr std::size_t kSharedObstacles = 24;

// What stands in one of 36 directions, each 10 deg wide.
struct ObstacleSector {
  double count = 0.0;       // of points within reach
  double nearest = 1000.0;  // cm to the nearest cell that holds an obstacle; 1000: none

  static constexpr auto fields() {
    return fieldList(field("count", &ObstacleSector::count),
                     field("nearest", &ObstacleSector::nearest, "cm", 0, 1000));
  }
};

// The gap nearest to the requested heading.
struct ObstacleGap {
  bool present = false;
  Angle heading;
  Angle width;

  static constexpr auto fields() {
    return fieldList(field("present", &ObstacleGap::present),
                     field("heading", &ObstacleGap::heading, "rad", -180, 180),
                     field("width", &ObstacleGap::width, "rad", 0, 180));
  }
};

// A square of 10 cm on the field.
struct ObstacleCell {
  Point2<Field> position;
  double count = 0.0;

  static constexpr auto fields() {
    return fieldList(field("position", &ObstacleCell::position),
                     field("count", &ObstacleCell::count, "", 0, 1e4));
  }
};

struct ObstacleEstimate {
  std::array<ObstacleSector, kObstacleSectors> sectors{};  // counter-clockwise, ahead is the first
  double toBall = 0.0;    // points in the corridor from the robot to the ball
  double toGoal = 0.0;    // from the ball to the opponents' goal, from the robot without a ball
  ObstacleGap gapToGoal;  // for a robot that wants to go to the opponents' goal
  FixedVector<ObstacleCell, kSharedObstacles> cells;  // the fullest of the own ones, fullest first

  static constexpr auto fields() {
    using O = ObstacleEstimate;
    return fieldList(field("sectors", &O::sectors), field("toBall", &O::toBall),
                     field("toGoal", &O::toGoal), field("gapToGoal", &O::gapToGoal),
                     field("cells", &O::cells));
  }
};

}  // namespace kelpie
