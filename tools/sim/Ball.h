// SPDX-License-Identifier: Apache-2.0
// The ball as a disc that rolls on the carpet: friction, and impulses from what it touches. It
// never leaves the ground. Robots do not feel it.
#pragma once

#include <vector>

#include "robot/body/FieldDescription.h"
#include "robot/core/Geometry.h"
#include "tools/sim/RobotModel.h"

namespace kelpie::sim {

struct BallParams {
  double keptPerFrame = 0.975;  // share of the speed after 1/30 s (checklist G52: 0.97..0.98)
  double friction = 6.0;        // cm/s2, what stops a slow ball
  double restitution = 0.45;    // against robots
  double wallRestitution = 0.5;
  double maxSpeed = 300.0;  // cm/s

  static constexpr auto fields() {
    using P = BallParams;
    return fieldList(field("keptPerFrame", &P::keptPerFrame, "", 0.5, 1),
                     field("friction", &P::friction, "cm/s2", 0, 200),
                     field("restitution", &P::restitution, "", 0, 1),
                     field("wallRestitution", &P::wallRestitution, "", 0, 1),
                     field("maxSpeed", &P::maxSpeed, "cm/s", 10, 1000));
  }
};

// An upright thing that does not move: a wall from a to b with half thickness `radius`; a post or
// beacon when a equals b.
struct Obstacle {
  Point2<Field> a;
  Point2<Field> b;
  double radius = 0.0;
};

// Goals (open at the mouth) and beacons.
std::vector<Obstacle> obstaclesOf(const body::FieldDescription& field);
Point2<Field> nearestOn(const Obstacle& obstacle, Point2<Field> p);

struct Ball {
  Point2<Field> position;
  Point2<Field> velocity;  // cm/s
};

// Rolls for `seconds`, exactly: dv/dt = -(k v + friction).
void roll(Ball& ball, double seconds, const BallParams& params);
void bounce(Ball& ball, const std::vector<Obstacle>& obstacles, const BallParams& params);

// One tick: rolls and touches, in steps of 2 ms because a foot moves 2 cm in a tick.
void tickBall(Ball& ball, const std::vector<RobotModel>& robots,
              const std::vector<Obstacle>& obstacles, const BallParams& params);

}  // namespace kelpie::sim
