// SPDX-License-Identifier: Apache-2.0
// What stands in words over the broadcast. Pure.
#pragma once

#include <string>
#include <vector>

#include "tools/broadcast/Stage.h"
#include "tools/sim/world/Truth.h"

namespace kelpie::broadcast {

// "red 2"
std::string nameOf(TeamColour team, int player);
// "Red 2 has the ball"; "Nobody has the ball"; null: nobody.
std::string ballWords(const Actor* holder, bool ballThere);
// What was called within the last seconds and is worth a banner, the newest; empty: nothing.
std::string bannerAt(const std::vector<sim::MatchEvent>& events, double seconds);

struct Call {
  double seconds = 0.0;
  std::string words;
};
// The newest calls until then, newest first, at most `count`.
std::vector<Call> callsUntil(const std::vector<sim::MatchEvent>& events, double seconds,
                             std::size_t count);

}  // namespace kelpie::broadcast
