// SPDX-License-Identifier: Apache-2.0
// Experiments on situations, those of tools/sim/staging/Scenes.h or others: a team (--a), red, in
// one kind or in several by turns, against another (--b), by the rules of 2005. With --fast from
// percepts, else from images on physical bodies. Keeps nothing.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "tools/experiments/match/Matches.h"
#include "tools/sim/staging/Scenes.h"

namespace kelpie::experiments {

using DrawScene = std::function<Expected<sim::StagedScene>(
    std::size_t kind, const body::FieldDescription& field, std::uint64_t seed)>;

struct StagedScenes {
  std::size_t kinds = 1;  // each is played `trials` times
  DrawScene draw;
  const char* opponents = "";    // the team that --b is when nobody names it
  std::vector<std::string> set;  // of the watched robot: --set words
  std::function<void(std::size_t kind, const Played& played)> judge;
};

// Of the farm's scenes, those.
DrawScene drawnAs(std::vector<std::string> kinds);

Status playScenes(const Request& request, const StagedScenes& scenes);

// When the first goal of that team fell, s from the beginning; nothing when none did.
std::optional<double> goalAfter(const Played& played, TeamColour team);

}  // namespace kelpie::experiments
