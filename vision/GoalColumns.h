// SPDX-License-Identifier: Apache-2.0
// Measures a goal candidate: where its posts end and how far away it is, column by column.
#pragma once

#include "vision/GoalFinder.h"

namespace kelpie::vision {

// Fills edges, cuts, distance and its standard deviation from the candidate's colour and box.
void measureGoal(const Scene& scene, const GoalParams& params, GoalCandidate& c);

}  // namespace kelpie::vision
