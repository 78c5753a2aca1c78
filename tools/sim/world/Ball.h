// SPDX-License-Identifier: Apache-2.0
// The ball, and the things on the field that stop it; the kinematic world's rolling and bouncing: a
// disc with friction that never leaves the ground.
#pragma once

#include <vector>

#include "robot/body/FieldDescription.h"
#include "robot/core/types/Geometry.h"

namespace kelpie::sim {

struct BallParams {
  double keptPerFrame = 0.975;  // share of the speed after 1/30 s (checklist G52: 0.97..0.98)
  double friction = 6.0;        // cm/s2, what stops a slow ball
  // Against robots: of 150 balls off a standing one 0.30 of the speed is left, off a physical one
  // 0.25 (tests/sim/BallContactTest.cpp).
  double restitution = 0.15;
  double wallRestitution = 0.5;
  double maxSpeed = 300.0;  // cm/s

  template <int = 0>
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

// A surface with horizontal normal n (towards the ball) moving at `speed` along it, `depth` inside
// the ball.
struct Impact {
  Point2<Field> normal;
  double depth = 0.0;
  double speed = 0.0;
};
void strike(Ball& ball, const Impact& impact, double restitution);

}  // namespace kelpie::sim
