// SPDX-License-Identifier: Apache-2.0
// Matches of four against four in which two teams (--a, --b) change colours: each seed is played
// twice. By the rules of 2005, from images on physical bodies, or with --fast of percepts. The
// first forward of red is the robot that is watched.
#pragma once

#include <functional>
#include <vector>

#include "tools/experiments/match/Matches.h"

namespace kelpie::experiments {

// `opponents`: the team that --b is when nobody names it.
Status playExchanged(const Request& request, const char* opponents,
                     const std::function<void(bool aIsRed, const Played& played)>& judge);

// Of each moment whether the ball is in play: from whistle to goal or half-time.
std::vector<bool> inPlay(const Played& played);

}  // namespace kelpie::experiments
