// SPDX-License-Identifier: Apache-2.0
// One run of a kick map: a robot that stands or walks kicks a ball at one place.
#include <cmath>

#include "tools/learn/kick/KickMapLearning.h"

namespace kelpie::learn {
namespace {

constexpr double kPushed = 1.0;     // cm: a ball that rests so far from its place is not there
constexpr std::uint32_t kFew = 30;  // messages, until a walk is even
constexpr std::uint32_t kMore = 16;

Angle turnUntilKick(const WalkRequest& walk) { return Angle::rad(walk.turn * kUntilKick); }

// Right and ahead, along half the turn.
Point2<Robot> wayUntilKick(const WalkRequest& walk) {
  const Angle half = turnUntilKick(walk) * 0.5;
  const double forward = walk.forward * kUntilKick;
  const double left = walk.left * kUntilKick;
  return {-left * half.cos() - forward * half.sin(), forward * half.cos() - left * half.sin()};
}

// Turned to the left by an angle.
Point2<Robot> turned(Point2<Robot> p, Angle by) {
  return {p.x * by.cos() - p.y * by.sin(), p.x * by.sin() + p.y * by.cos()};
}

}  // namespace

LastSteps drawLastSteps(Random& random) {
  LastSteps last;
  last.walk.forward = random.uniform(5.0, 20.0);
  last.walk.left = random.uniform(-5.0, 5.0);
  last.walk.turn = random.uniform(-0.3, 0.3);
  last.messages = static_cast<int>(kFew + random.index(kMore));
  return last;
}

Point2<Robot> placeAtKick(Point2<Robot> asked, const WalkRequest& walk) {
  return turned(asked - wayUntilKick(walk), -turnUntilKick(walk));
}

Point2<Robot> placeAsAsked(Point2<Robot> atKick, const WalkRequest& walk) {
  return turned(atKick, turnUntilKick(walk)) + wayUntilKick(walk);
}

KickRun kickFrom(Point2<Robot> place, MotionKind motion, const KickStart& standing) {
  const KickStart start = withBallAt(place, standing);
  const Point2<Robot> lies = robotFromField(start.pose, start.ball);
  if (start.walker->failed() || (lies - place).norm() > kPushed) return {{}, false};
  return {tryKick(actuator::standardMotions()[motion], motion, start), true};
}

KickRun kickInStep(Point2<Robot> place, MotionKind motion, const KickStart& walking,
                   const WalkRequest& walk) {
  const KickStart start = withBallJustAt(placeAsAsked(place, walk), walking);
  KickRun run{tryKick(actuator::standardMotions()[motion], motion, start), true};
  run.kicked.direction = run.kicked.direction - turnUntilKick(walk);
  return run;
}

}  // namespace kelpie::learn
