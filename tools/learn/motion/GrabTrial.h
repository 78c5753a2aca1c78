// SPDX-License-Identifier: Apache-2.0
// A robot walks at a ball, lying or rolling, grabs it, and keeps it while it turns and walks. It
// knows where the ball is by its true place, some time late and a little wrong, as a vision would:
// what is tried is the body.
#pragma once

#include "robot/core/Random.h"
#include "tools/learn/motion/BallInHold.h"

namespace kelpie::learn {

struct GrabPlace {
  Point2<Robot> ball;  // cm, as the robot begins to walk
  double speed = 0.0;  // cm/s
  Angle direction;     // of its way, left of the robot's own
  double error = 1.0;  // cm, sd of where the robot thinks it is, the same for a whole approach
  MotionKind motion = MotionKind::grab;  // one of MotionUse::grab
};

enum class GrabEnd : std::uint8_t { missed, held, fell };

// Walks at the ball and grabs it; ends 0.5 s after the motion. `missed` too when it could not be
// reached in 8 s.
GrabEnd grab(const GrabPlace& place, Random& random, PhysicalWalker& walker);

// With a ball in its hold: turns by half a circle, walks 50 cm ahead.
void turnWithBall(double radPerSecond, PhysicalWalker& walker);
void walkWithBall(double cmPerSecond, double cm, PhysicalWalker& walker);

}  // namespace kelpie::learn
