// SPDX-License-Identifier: Apache-2.0
// How long a team did not see a ball that a hand had put elsewhere, by what each of its robots took
// for the ball and by the true places.
#pragma once

#include <optional>

#include "tools/experiments/team/TeamMatch.h"

namespace kelpie::experiments {

// Seconds from the throw until a robot of that team has the ball in two images in a row, all of
// which was exposed after it, and rightly; nothing when none has.
std::optional<double> foundAfter(const TeamMatch& match, TeamColour team, double thrown);

}  // namespace kelpie::experiments
