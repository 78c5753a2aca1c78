// SPDX-License-Identifier: Apache-2.0
// What the localiser remembers of other robots between frames. Plain data.
#pragma once

#include <array>
#include <cstdint>

#include "gps/players/ObstacleMap.h"
#include "robot/core/types/TeamMessage.h"

namespace kelpie::gps {

// A Gaussian over a place on the field in information form: Y = P^-1 row by row, y = Y x. All
// zero: nothing is known.
struct Information {
  std::array<double, 4> matrix{};
  std::array<double, 2> vector{};
};

struct OpponentFilter {
  bool known = false;  // seen by somebody and not forgotten
  Information belief;
  double secondsSinceSeen = 0.0;
  Information unsent;  // of the own sightings since the last message
  bool seenSinceMessage = false;
  bool assigned = false;  // to a sighting of this frame, or of the message at hand
};

struct Opponents {
  bool started = false;
  std::array<OpponentFilter, kOpponents> filters{};
};

struct Teammate {
  bool present = false;
  TeamMessage last;  // its age grows
};

// By player number less one; the own stays empty.
using Teammates = std::array<Teammate, kTeammates + 1>;

struct PlayersState {
  Opponents opponents;
  Teammates mates{};
  // Numbers of the mates' messages whose ball has been a landmark, or was found unfit.
  std::array<std::uint16_t, kTeammates + 1> usedBalls{};
  TeamMessage message;
  double secondsSinceMessage = 1e9;
  ObstacleMap obstacles;
};

}  // namespace kelpie::gps
