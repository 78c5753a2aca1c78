// SPDX-License-Identifier: Apache-2.0
// Experiments on the situations of tools/sim/staging/Scenes.h: a team (--a), red, in one kind or in
// several by turns, against another (--b), by the rules of 2005. With --fast from percepts, else
// from images on physical bodies. Keeps nothing.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "tools/experiments/match/Matches.h"

namespace kelpie::experiments {

constexpr double kNever = 100.0;  // s, of what does not happen: longer than a scene

struct StagedScenes {
  std::vector<std::string> kinds;  // each is played `trials` times
  const char* opponents = "";      // the team that --b is when nobody names it
  std::vector<std::string> set;    // of the watched robot: --set words
  std::function<void(std::size_t kind, const Played& played)> judge;
};

Status playScenes(const Request& request, const StagedScenes& scenes);

// When the first goal of that team fell, s from the beginning; nothing when none did.
std::optional<double> goalAfter(const Played& played, TeamColour team);

}  // namespace kelpie::experiments
