// SPDX-License-Identifier: Apache-2.0
// What each kick does with the ball from each place of it: whether the ball goes, where to, how far
// and how sure all that is. Measured on varied physical models, of robots that stand, that walk
// until they kick, and that hold the ball. A free ball lies anywhere within half a step of a grid's
// place, a held one where the hold has it. Of a pair of kicks the left one is measured, of a kick
// that is its own mirror image the places to the right. Says nothing of a ball that rolls, nor of a
// robot that another one pushes.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "robot/core/Random.h"
#include "tools/learn/KickTrial.h"

namespace kelpie::learn {

constexpr double kBallGoes = 30.0;  // cm, a ball that gets no further has not been kicked

// What the robot does until it kicks.
enum class KickFrom : std::uint8_t { standing, walking, hold };
constexpr std::size_t kKickFroms = 3;
constexpr std::array<const char*, kKickFroms> kKickFromNames{"STANDING", "WALKING", "HELD"};

// What a kick does with a ball at one place, of all runs in which a ball could lie there.
struct KickCell {
  int runs = 0;             // none where the robot itself is
  double went = 0.0;        // share of the runs in which the ball went
  Angle direction;          // of its way, mean of those that went
  Angle directionSd;        // about that mean
  double distance = 0.0;    // cm until it lies still
  double distanceSd = 0.0;  // cm
  double fell = 0.0;        // share of the runs
};

// Places that are alike: a ball anywhere in them goes, about the same way.
struct KickWindow {
  Point2<Robot> best;   // the place whose neighbours do best, too
  Point2<Robot> least;  // corners
  Point2<Robot> most;
  KickCell whole;  // over all its places
};

struct KickGrid {
  MotionKind motion = MotionKind::none;
  KickFrom from = KickFrom::standing;  // from the hold: one cell, no places
  std::vector<double> aside;           // cm to the right, rising
  std::vector<double> ahead;           // cm, rising
  std::vector<KickCell> cells;         // [ahead][aside]
  KickWindow window;
  double frames = 0.0;      // of 1/30 s
  actuator::MotionWay way;  // of the robot, until it stands again

  const KickCell& cell(std::size_t row, std::size_t column) const {
    return cells[row * aside.size() + column];
  }
};
using KickMap = std::vector<KickGrid>;

struct KickMapPlan {
  std::uint64_t seed = 1;  // of models and places
  int trials = 24;         // at each place, each on another model: some kick half as far
  double aside = 10.0;     // cm, the outermost places
  double nearest = 10.0;   // cm ahead
  double furthest = 18.0;  // cm ahead
  double step = 2.0;       // cm between places
};

// The seed of the first model; those of the searches of kicks and of their judges lie elsewhere.
constexpr std::uint64_t firstModelOf(const KickMapPlan& plan) { return 20000 + 100 * plan.seed; }

// The last steps up to a ball, drawn: 5 to 20 cm/s ahead, a little aside and turning.
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
// are told from where it looks by then.
KickRun kickInStep(Point2<Robot> place, MotionKind motion, const KickStart& walking,
                   const WalkRequest& walk);

KickCell cellOf(const std::vector<KickRun>& runs);
// Between the places, as pycode/lib/kick_table.py does it: of no runs outside the grid and next to
// a place of no runs.
KickCell cellAt(const KickGrid& grid, Point2<Robot> place);
// The best place and those about it.
KickWindow windowOf(const KickGrid& grid);

// Is told how many of how many runs are done, from one thread at a time; `false` ends the work, and
// the map is then empty.
using KickMapTold = std::function<bool(std::size_t done, std::size_t all)>;
KickMap learnKickMap(const KickMapPlan& plan, const KickMapTold& told);

}  // namespace kelpie::learn
