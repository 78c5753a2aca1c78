// SPDX-License-Identifier: Apache-2.0
// The kinematic ball among kinematic robots: impulses from what it touches. Robots do not feel it.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "tools/sim/bodies/RobotModel.h"
#include "tools/sim/world/Ball.h"

namespace kelpie::sim {

struct BallTouch {
  std::optional<std::size_t> strongest;  // who changed the ball's velocity the most
  bool several = false;                  // more than one robot touched it
};

// One tick of a ball among the robots that may touch it: rolls and touches, in steps of 2 ms
// because a foot moves 2 cm in a tick.
BallTouch tickBall(Ball& ball, const std::vector<const RobotModel*>& robots,
                   const std::vector<Obstacle>& obstacles, const BallParams& params);

}  // namespace kelpie::sim
