// SPDX-License-Identifier: Apache-2.0
// Situations of a match, each a few seconds long: who is where, with what ball, drawn by a seed.
// Red is the team whose situation it is; the same seed with colours exchanged gives it to the other
// team. Keeps nothing.
#pragma once

#include <string>
#include <vector>

#include "robot/core/Expected.h"
#include "tools/sim/staging/Staging.h"

namespace kelpie::sim {

struct StagedScene {
  std::string robots;    // "2v2", number 1 of two or more in the goal
  Staging staging;       // a place for each of them, and the ball
  double seconds = 0.0;  // of play
};

// "free-ball", "contested", ...
const std::vector<std::string>& sceneKinds();

// Where all may stand, by the staging's own rules. An error names the kinds that there are.
Expected<StagedScene> drawScene(const std::string& kind, const body::FieldDescription& field,
                                std::uint64_t seed);

}  // namespace kelpie::sim
