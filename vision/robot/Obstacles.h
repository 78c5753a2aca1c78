// SPDX-License-Identifier: Apache-2.0
// Dark and grey pixels on the carpet along scan lines up the image: feet and shadows of robots,
// referees' shoes. No objects are made of them. A white robot's body gives none; its grey legs, and
// what lies in its shadow, do.
#pragma once

#include "robot/core/Percepts.h"
#include "vision/Scene.h"
#include "vision/robot/ObstacleParams.h"

namespace kelpie::vision {

using ObstaclePoints = FixedVector<ObstaclePoint, 64>;

struct Obstacles {
  ObstaclePoints points;    // the lowest of each scan line
  std::uint16_t ahead = 0;  // pixels in the box before the robot
};

// Whether a pixel may be of an obstacle.
bool isObstacleColour(const Sampler& sampler, int px, int py, const ObstacleParams& p);

Obstacles findObstacles(const Scene& scene, const ObstacleParams& params, VisionCounts& counts);

}  // namespace kelpie::vision
