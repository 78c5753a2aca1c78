// SPDX-License-Identifier: Apache-2.0
// What each kick does with the ball from each place of it: whether the ball goes, where to, how far
// and how sure all that is. Measured on varied physical models; a free ball lies anywhere within
// half a step of a grid's place, a held one where the hold has it. Of a pair of kicks the left one
// is measured, of a kick that is its own mirror image the places to the right. Says nothing of a
// ball that rolls, nor of a robot that another one pushes.
#pragma once

#include <functional>
#include <vector>

#include "tools/learn/KickTrial.h"

namespace kelpie::learn {

constexpr double kBallGoes = 30.0;  // cm, a ball that gets no further has not been kicked

// What a kick does with a ball at one place, of all runs in which a ball could lie there.
struct KickCell {
  int runs = 0;        // none where the robot itself is
  double went = 0.0;   // share of the runs in which the ball went
  Angle direction;     // of its way, mean of those that went
  Angle directionSd;   // about that mean
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
  bool held = false;           // one cell, no places
  std::vector<double> aside;   // cm to the right, rising
  std::vector<double> ahead;   // cm, rising
  std::vector<KickCell> cells; // [ahead][aside]
  KickWindow window;
  double frames = 0.0;    // of 1/30 s
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

// One run: a ball that could not lie at its place does not count.
struct KickRun {
  Kicked kicked;
  bool counts = true;
};
// The ball is put down at that place of a standing robot, which then kicks.
KickRun kickFrom(Point2<Robot> place, MotionKind motion, const KickStart& standing);
// The ball is put there as a robot is asked to kick that does anything, walks for example.
KickRun kickAtOnce(Point2<Robot> place, MotionKind motion, const KickStart& start);

KickCell cellOf(const std::vector<KickRun>& runs);
// Between the places, as pycode/lib/kick_table.py does it: of no runs outside the grid and next to a
// place of no runs.
KickCell cellAt(const KickGrid& grid, Point2<Robot> place);
// The best place and those about it.
KickWindow windowOf(const KickGrid& grid);

// Is told how many of how many runs are done, from one thread at a time; `false` ends the work, and
// the map is then empty.
using KickMapTold = std::function<bool(std::size_t done, std::size_t all)>;
KickMap learnKickMap(const KickMapPlan& plan, const KickMapTold& told);

}  // namespace kelpie::learn
