// SPDX-License-Identifier: Apache-2.0
// Learns a kick map (tools/sim/kicks/KickMap.h): of robots that stand, that walk until they kick,
// and that hold the ball, on varied physical models.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "robot/core/Random.h"
#include "tools/learn/kick/KickTrial.h"

namespace kelpie::learn {

using sim::cellAt;
using sim::isItsOwnMirror;
using sim::kBallGoes;
using sim::KickCell;
using sim::KickFrom;
using sim::KickGrid;
using sim::KickMap;
using sim::KickWindow;
using sim::kKickFromNames;
using sim::kKickFroms;

struct KickMapPlan {
  std::uint64_t seed = 1;  // of models and places
  int trials = 24;         // at each place, each on another model: some kick half as far
  double lateral = 10.0;   // cm, the outermost places
  double nearest = 10.0;   // cm ahead
  double furthest = 18.0;  // cm ahead
  double step = 2.0;       // cm between places
};

// The seed of the first model; those of the searches of kicks and of their judges lie elsewhere.
constexpr std::uint64_t firstModelOf(const KickMapPlan& plan) { return 20000 + 100 * plan.seed; }

// The last steps up to a ball, drawn: 5 to 20 cm/s ahead, a little sideways and turning.
struct LastSteps {
  WalkRequest walk;
  int messages = 0;  // until the kick is asked for
};
LastSteps drawLastSteps(Random& random);

// From asking until a walking robot's motion begins, on the mean: two vectors are in flight and the
// step is ended first. Till then it walks on.
constexpr double kUntilKick = 0.19;  // s
// Where a resting ball will be in the robot frame by then, and where it must be for that as the
// kick is asked for.
Point2<Robot> placeAtKick(Point2<Robot> asked, const WalkRequest& walk);
Point2<Robot> placeAsAsked(Point2<Robot> atKick, const WalkRequest& walk);

// One run: a ball that could not lie at its place does not count.
struct KickRun {
  Kicked kicked;
  bool counts = true;
};
// The ball is put down at that place of a standing robot, which then kicks.
KickRun kickFrom(Point2<Robot> place, MotionKind motion, const KickStart& standing);
// The ball is put so that it is at that place when the motion of a walking robot begins; directions
// are measured from where it looks by then.
KickRun kickInStep(Point2<Robot> place, MotionKind motion, const KickStart& walking,
                   const WalkRequest& walk);

KickCell cellOf(const std::vector<KickRun>& runs);
// The best place and those about it.
KickWindow windowOf(const KickGrid& grid);

// Is called with how many of how many runs are done, from one thread at a time; `false` ends the
// work, and the map is then empty.
using KickMapListener = std::function<bool(std::size_t done, std::size_t all)>;
KickMap learnKickMap(const KickMapPlan& plan, const KickMapListener& listener);

}  // namespace kelpie::learn
