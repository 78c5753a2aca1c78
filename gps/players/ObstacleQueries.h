// SPDX-License-Identifier: Apache-2.0
// What behaviours ask of the map of obstacles: how much stands in a corridor or a sector, and which
// way is free. Opponents and mates are in it as far as somebody saw them.
#pragma once

#include "gps/players/ObstacleMap.h"

namespace kelpie::gps {

struct ObstacleView {
  const ObstacleMap& map;
  const body::FieldDescription& field;
  const ObstacleMapParams& params;
};

using Sectors = std::array<ObstacleSector, kObstacleSectors>;

// Points within half the corridor's width of the straight way between two places.
double countInCorridor(const ObstacleView& view, Point2<Field> from, Point2<Field> to);

// Points within reach around a robot, by direction in its frame.
Sectors sectorsAround(const ObstacleView& view, const Pose2& robot);

// Points of the sectors whose middle is within half the width of a heading.
double countInSector(const Sectors& sectors, Angle heading, Angle width);

// The direction nearest to the desired one in any run of free sectors, at least half the needed
// width from both ends of the run; absent when all are too narrow.
ObstacleGap bestGap(const Sectors& sectors, Angle desired, const ObstacleMapParams& params);

// Everything that is published.
ObstacleEstimate extractObstacles(const ObstacleView& view, const WorldModel& world);

}  // namespace kelpie::gps
