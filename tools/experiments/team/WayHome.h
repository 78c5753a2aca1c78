// SPDX-License-Identifier: Apache-2.0
// How good a non-attacker's way home was, by the true places: when it got there, and how often it
// ran into an opponent on the way.
#pragma once

#include <optional>

#include "tools/experiments/match/Played.h"

namespace kelpie::experiments {

struct WayHome {
  std::optional<double> home;  // s; nothing when it never got there
  int contacts = 0;            // until then

  bool touched() const { return contacts > 0; }
};

// Of the watched robot, of a red team: home is where it says that it wants to be as a defender. A
// contact ends when the two have been apart for half a second.
WayHome wayHomeOf(const Played& played, std::uint8_t player);

}  // namespace kelpie::experiments
