// SPDX-License-Identifier: Apache-2.0
// The gaps in a goal's mouth that nobody stands in: directions between the posts in which the wall
// behind shows its colour from foot to top (thesis 2006 section 6.4.2). What stands before or in
// the goal hides it. A ball does not count as an obstacle.
#pragma once

#include "vision/goal/GoalCandidate.h"
#include "vision/goal/GoalShape.h"

namespace kelpie::vision {

constexpr std::size_t kMaxGoalGaps = 6;
using GoalGaps = FixedVector<GoalGap, kMaxGoalGaps>;

void findGaps(const Scene& scene, const GoalCandidate& c, const GoalShape& shape, GoalGaps& gaps);

}  // namespace kelpie::vision
