// SPDX-License-Identifier: Apache-2.0
// Dark and grey pixels on the carpet along scan lines up the image: feet and shadows of robots,
// referees' shoes. No objects are made of them. A white robot's body gives none; its grey legs, and
// what lies in its shadow, do. What is dark or grey is measured against the carpet that the same
// line saw just below: a fixed grey took a dark carpet for obstacles.
#pragma once

#include "robot/core/ScratchVector.h"
#include "robot/core/types/Percepts.h"
#include "vision/Scene.h"
#include "vision/robot/ObstacleParams.h"

namespace kelpie::vision {

constexpr std::size_t kMaxObstaclePoints = 64;
using ObstaclePoints = ScratchVector<ObstaclePoint, kMaxObstaclePoints>;

struct Obstacles {
  ObstaclePoints points;    // the lowest of each scan line
  std::uint16_t ahead = 0;  // samples in the box before the robot, one for each 2 px of a line
};

Obstacles findObstacles(const Scene& scene, const ObstacleParams& params, VisionCounts& counts);

}  // namespace kelpie::vision
