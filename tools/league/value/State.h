// SPDX-License-Identifier: Apache-2.0
// A moment of play as one team sees it, and what of it tells whether that team is about to score.
// From true places alone, on that team's own field, so that one description serves both teams and a
// mirrored moment is the same to the other one. Knows no plans, no falls and no kick that has begun
// but not yet met the ball; the way of a ball is that of the kinematic world, without bounces.
#pragma once

#include "robot/body/FieldDescription.h"
#include "tools/sim/world/Truth.h"

namespace kelpie::value {

struct TeamState {
  Point2<Field> ball;
  Point2<Field> velocity;                     // cm/s
  FixedVector<Pose2, sim::kMaxRobots> own;    // who is off the carpet does not play
  FixedVector<Pose2, sim::kMaxRobots> other;  // so
};

TeamState stateOf(const sim::TruthFrame& truth, TeamColour team,
                  const body::FieldDescription& field);

// The goal is the other team's. Distances to it are to the nearest point of its mouth.
struct Features {
  double goal = 0.0;         // cm from the ball
  double restGoal = 0.0;     // cm from where the ball comes to rest, 0 when that is in the goal
  double towards = 0.0;      // cm/s, of the ball, towards the middle of the mouth
  double mouth = 0.0;        // deg, the angle of the mouth at the ball
  double opening = 0.0;      // deg, of it without what robots cover
  double entering = 0.0;     // cm that the ball rolls beyond the line between the posts if it meets
                             // nobody, at most kBeyond
  double free = 0.0;         // the same; 0 when a robot stands in its way
  double ownReach = 0.0;     // cm from the ball to the nearest own robot, at most kFar
  double otherReach = 0.0;   // so
  double lead = 0.0;         // cm that the own one is nearer to where the ball will be
  double ownBehind = 0.0;    // deg between its way to the ball and the ball's to the goal
  double ownAim = 0.0;       // deg between its heading and the ball's way to the goal
  double otherBehind = 0.0;  // deg, as ownBehind, of the nearest other one towards our goal
  double guards = 0.0;       // others that are nearer to their goal than the ball
  double ownHold = 0.0;      // 1 when the ball is in an own robot's hold
  double otherHold = 0.0;    // so
  double own = 0.0;          // robots that play
  double other = 0.0;        // so

  template <int = 0>
  static constexpr auto fields() {
    using F = Features;
    return fieldList(field("goal", &F::goal, "cm"), field("restGoal", &F::restGoal, "cm"),
                     field("towards", &F::towards, "cm/s"), field("mouth", &F::mouth, "deg"),
                     field("opening", &F::opening, "deg"), field("entering", &F::entering, "cm"),
                     field("free", &F::free, "cm"), field("ownReach", &F::ownReach, "cm"),
                     field("otherReach", &F::otherReach, "cm"), field("lead", &F::lead, "cm"),
                     field("ownBehind", &F::ownBehind, "deg"), field("ownAim", &F::ownAim, "deg"),
                     field("otherBehind", &F::otherBehind, "deg"), field("guards", &F::guards),
                     field("ownHold", &F::ownHold), field("otherHold", &F::otherHold),
                     field("own", &F::own), field("other", &F::other));
  }
};

constexpr double kBeyond = 200.0;  // cm
constexpr double kFar = 300.0;     // cm; also where a team has no robot

Features featuresOf(const TeamState& state, const body::FieldDescription& field);

}  // namespace kelpie::value
