// SPDX-License-Identifier: Apache-2.0
// Where a robot believes that something stands on the field, whatever it is; part of WorldModel.h.
// Counts are of points seen, less what was forgotten since. Beacons and goals are not listed: they
// stand where the field description says.
#pragma once

#include "robot/core/FixedVector.h"
#include "robot/core/types/Geometry.h"

namespace kelpie {

constexpr std::size_t kObstacleCells = 128;

// A square of 10 cm on the field.
struct ObstacleCell {
  Point2<Field> position;  // its middle
  double own = 0.0;        // points that its own camera saw
  double heard = 0.0;      // points that a teammate reported

  template <int = 0>
  static constexpr auto fields() {
    return fieldList(field("position", &ObstacleCell::position),
                     field("own", &ObstacleCell::own, "", 0, 1e4),
                     field("heard", &ObstacleCell::heard, "", 0, 1e4));
  }
};

using ObstacleCells = FixedVector<ObstacleCell, kObstacleCells>;

}  // namespace kelpie
