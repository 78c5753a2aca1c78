// SPDX-License-Identifier: Apache-2.0
// Which robot of a match, and what it is called on the stage.
#pragma once

#include <string>
#include <utility>

#include "robot/core/types/FrameInput.h"

namespace kelpie::broadcast {

using Player = std::pair<TeamColour, int>;
constexpr std::size_t kRobotsOfTeam = 4;

// "red1": the body of a robot; its joints are "red1_free" and "red1_<joint index>".
inline std::string slotName(TeamColour team, int player) {
  return (team == TeamColour::red ? "red" : "blue") + std::to_string(player);
}
constexpr std::size_t kHinges = 16;  // the head's four and the legs' twelve

}  // namespace kelpie::broadcast
