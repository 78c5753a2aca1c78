// SPDX-License-Identifier: Apache-2.0
// What really happened in one match: the true places at each image, and the stretches in which the
// ball was in play, from the world's log or a match's whole one. What is before a kick-off's
// whistle, after a goal, and while somebody has taken the ball away is no play. A match without the
// rules is in play from its start on.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "robot/core/Expected.h"
#include "tools/sim/world/Truth.h"

namespace kelpie::value {

// From the whistle to a goal, or to the end of the half or of the match.
struct Stretch {
  double begin = 0.0;              // s
  double end = 0.0;                // s
  std::optional<TeamColour> goal;  // that ended it
};

struct PlayedTruth {
  std::vector<sim::TruthFrame> frames;
  std::vector<sim::MatchEvent> events;
};

// Error: the file cannot be read, or holds no true places.
Expected<PlayedTruth> readTruth(const std::string& path);

std::vector<Stretch> stretchesOf(const PlayedTruth& match);

// The frames of one stretch, as indices: those from `first` on and before `last`.
struct FrameRange {
  std::size_t first = 0;
  std::size_t last = 0;
};
FrameRange framesOf(const PlayedTruth& match, const Stretch& stretch);

}  // namespace kelpie::value
