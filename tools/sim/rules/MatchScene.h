// SPDX-License-Identifier: Apache-2.0
// What the referee sees: where everybody and the ball are at one time, in the red team's field as
// everything in Truth.h. Each rule beside this file is a step of such scenes, in the order of time,
// one for each tick of 8 ms.
#pragma once

#include <cstddef>
#include <optional>

#include "robot/body/FieldDescription.h"
#include "tools/sim/world/Ball.h"
#include "tools/sim/world/Truth.h"

namespace kelpie::sim {

constexpr std::uint8_t kGoalie = 1;  // the player that may be in its own goal box

struct ScenePlayer {
  TeamColour team = TeamColour::red;
  std::uint8_t number = 1;
  Pose2 pose;
  bool upright = true;
  bool playing = true;  // not off the field for a penalty
};

struct MatchScene {
  TimeUs time;
  FixedVector<ScenePlayer, kMaxRobots> players;
  Ball ball;
  bool ballAway = false;                   // somebody has taken it, and `ball` is where it was
  std::optional<std::size_t> ballToucher;  // of the players, who moved it in this tick
  std::optional<std::size_t> lastToucher;  // who was the last to do so
};

inline TeamColour otherTeam(TeamColour team) {
  return team == TeamColour::red ? TeamColour::blue : TeamColour::red;
}

// From the red team's field to the one that the team itself sees, and back: blue's is turned.
Point2<Field> ownView(const body::FieldDescription& field, TeamColour team, Point2<Field> p);
Pose2 ownView(const body::FieldDescription& field, TeamColour team, const Pose2& pose);

// From above a robot is a stripe of 14 cm, as wide as its shoulders, round the line from its hind
// shoulders to the middle of its head and front legs. Distances are from that line.
constexpr double kStripeFront = 8.0;   // cm ahead of the neck base
constexpr double kStripeRear = -11.0;  // cm
constexpr double kStripeHalfWidth = 7.0;
Obstacle stripeOf(const Pose2& robot);
double stripeDistance(const Pose2& robot, Point2<Field> p);
double stripeDistance(const Pose2& one, const Pose2& other);

// No player that plays, but for one, has its neck base nearer to that place than so.
bool isFree(const MatchScene& scene, Point2<Field> place, double apart,
            std::optional<std::size_t> butFor = std::nullopt);

}  // namespace kelpie::sim
