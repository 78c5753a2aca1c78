// SPDX-License-Identifier: Apache-2.0
// Whether what passed every check is a goal: plain facts of the candidate, and the log odds that it
// is none. Clothes and boxes behind the carpet pass each single check now and then, but seldom all
// of them well. Weak where only a few columns of a goal show: then either error is likely.
#pragma once

#include "vision/GoalFinder.h"
#include "vision/GoalShape.h"

namespace kelpie::vision {

struct GoalFacts {
  double wall = 0.0;       // cm, camera to the wall
  double seen = 0.0;       // cm of the mouth's line between the ends
  double lowest = -1e9;    // px below the field edge, of the lowest foot
  double meanFoot = 0.0;   // the same in the mean of the chosen columns
  double misfit = 0.0;     // cost of the fitted shape for each measured column
  double footError = 0.0;  // deg, of the middle column
  double measured = 0.0;   // columns whose height tells their distance
  double chosen = 0.0;     // columns of the goal
  double chosenShare = 0.0;
  double edges = 0.0;     // field edges in view
  double coloured = 0.0;  // area of its samples to that of the box of its columns
  double hidden = 0.0;    // ends before which a robot stands
  double aside = 0.0;     // cm of the camera from the goal's axis
  double topCut = 0.0;    // 1: the image cuts a column's top
};

GoalFacts goalFacts(const Scene& scene, const GoalCandidate& c, const GoalShape& shape,
                    const GoalParams& p);

// Natural log of the odds that it is no goal, up to a constant (logistic regression on candidates
// of 60 000 rendered views; experiments.md tells how).
double goalDoubt(const GoalFacts& facts);

}  // namespace kelpie::vision
