// SPDX-License-Identifier: Apache-2.0
// Plays many matches, as many at a time as there are cores: a match is processes of its own, so
// that threads suffice here.
#pragma once

#include <functional>

#include "tools/experiments/harness/Trials.h"
#include "tools/experiments/match/Played.h"
#include "tools/session/Session.h"

namespace kelpie::experiments {

// A match as the request asks for it: body, randomised world, parameter files; the seed is the
// trial's.
cli::SessionOptions sessionOf(const Request& request, const Trial& trial);

// The folder of a side that the request names, or that of a team of the source tree.
std::string sideOr(const std::string& folder, const char* usual);

// What is played: `count` matches, by their numbers from 0.
struct Matches {
  int count = 0;
  std::function<cli::SessionOptions(int number)> session;
  // Called for each as it ends, one at a time, in any order. `played` is empty without keepFrames.
  std::function<void(int number, const cli::SessionResult& result, const Played& played)> judge;
};

// Error: the seed and the trouble of the first match that broke, or that the user interrupted it.
Status playMatches(const Request& request, const Matches& matches);

}  // namespace kelpie::experiments
