// SPDX-License-Identifier: Apache-2.0
// Follows the play as television does: from the side line, smoothly, with ball and nearest robots
// in the picture; at a goal the picture comes from beside it. It knows the whole match beforehand,
// so that it moves ahead of the play and never jerks. Pure: the same course gives the same views.
#pragma once

#include <vector>

#include "robot/body/FieldDescription.h"
#include "tools/broadcast/Course.h"
#include "tools/broadcast/View.h"

namespace kelpie::broadcast {

// A view for each of the times, which rise. `aspect`: the picture's width over its height.
std::vector<View> followPlay(const Course& course, const body::FieldDescription& field,
                             const std::vector<double>& times, double aspect);

// Seconds before and after a goal that its own camera shows.
constexpr double kBeforeGoal = 1.8;
constexpr double kAfterGoal = 1.6;

}  // namespace kelpie::broadcast
