// SPDX-License-Identifier: Apache-2.0
// What the use of field lines remembers between frames. Plain data.
#pragma once

#include <cstdint>

#include "gps/lines/FieldFeatures.h"
#include "gps/pose/PoseSearch.h"
#include "robot/core/FixedVector.h"
#include "robot/core/types/Geometry.h"
#include "robot/core/types/Percepts.h"

namespace kelpie::gps {

constexpr std::size_t kMapPoints = 128;

struct MapPoint {
  LinePointKind kind = LinePointKind::line;
  Point2<Robot> place;
  double weight = 0.0;        // of its sightings, by their distance: their mean
  double decayedCount = 0.0;  // sightings less the decay
};

// The map of a standing robot.
struct LineMap {
  FixedVector<MapPoint, kMapPoints> points;
  double age = 0.0;           // s of standing
  double sinceDecay = 0.0;    // s
  double newCount = 0.0;      // of the sightings of lines and border since the map was last used
  std::uint32_t refused = 0;  // frames in a row in which the lines matched no mode
  double unmatchedShare =
      0.0;  // of lines and border, those in no known point's region; over a second
};

struct LinesState {
  LineMap map;
  PoseSearch search;
  bool searchServed = false;  // the request at hand has been answered
  FieldFeatures features;     // built once from the field's description
};

}  // namespace kelpie::gps
