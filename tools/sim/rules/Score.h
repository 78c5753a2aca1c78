// SPDX-License-Identifier: Apache-2.0
// What a match has come to.
#pragma once

#include <array>
#include <vector>

#include "tools/sim/rules/Fouls.h"

namespace kelpie::sim {

struct Goal {
  TeamColour team = TeamColour::red;  // that scored
  double time = 0.0;                  // s
  bool own = false;                   // a robot of the other team touched it last
  std::uint8_t player = 0;            // that did; 0 = nobody known
};

struct Score {
  int red = 0;   // balls in the blue goal, y = length
  int blue = 0;  // balls in the yellow goal, y = 0
  int outs = 0;
  std::vector<Goal> goals;  // in their order
  // With the rules only: by Offence, of red and of blue; balls put elsewhere as they went nowhere.
  std::array<std::array<int, kOffenceCount>, 2> penalties{};
  int stuck = 0;
};

}  // namespace kelpie::sim
