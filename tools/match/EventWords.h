// SPDX-License-Identifier: Apache-2.0
// What the referee calls, and what people do to ball and robots, as sentences.
#pragma once

#include <string>

#include "tools/sim/world/Truth.h"

namespace kelpie::match {

// "Goal of red by player 2."
std::string sentenceOf(const sim::MatchEvent& event);

}  // namespace kelpie::match
