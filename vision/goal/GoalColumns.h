// SPDX-License-Identifier: Apache-2.0
// A goal seen as upright columns of its colour (in the level image), each with the foot and the top
// of the wall that it shows. Columns that stand on green and whose distances agree are the goal;
// clothes behind it that are taller or stand on the floor, and columns whose foot a robot hides,
// drop out. Fails where the foot is outside the image in all columns.
#pragma once

#include "vision/goal/GoalCandidate.h"
#include "vision/goal/GoalColour.h"

namespace kelpie::vision {

// Fills columns, box, edges, cuts, distance and its standard deviation from the candidate's colour
// and box.
void measureGoal(const Scene& scene, const GoalFinderParams& params, const CarpetColour& carpet,
                 GoalCandidate& c);

}  // namespace kelpie::vision
