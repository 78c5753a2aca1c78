// SPDX-License-Identifier: Apache-2.0
// What takes a robot off the field, and the fouls that one robot's place alone shows: a forward in
// its own goal box ("illegal defender", checklist A-4.3.2.1), a robot off the carpet, one that lies
// and does not get up. A robot's place is its neck base.
#pragma once

#include <array>
#include <optional>

#include "tools/sim/rules/MatchScene.h"

namespace kelpie::sim {

enum class Offence : std::uint8_t {
  ownBox,
  leftField,
  fallen,
  heldTooLong,
  carriedTooFar,
  pushing,
};
constexpr std::size_t kOffenceCount = 6;
const char* wordsFor(Offence offence);  // "illegal defender"

struct Foul {
  std::size_t player = 0;
  Offence offence = Offence::ownBox;
};
using Fouls = FixedVector<Foul, kMaxRobots>;

struct FoulState {
  // Since when each robot has stood so.
  using Since = std::array<std::optional<TimeUs>, kMaxRobots>;
  Since inBox;
  Since offCarpet;
  Since lying;
};

// At most one foul of each robot.
Fouls step(const MatchScene& scene, const body::FieldDescription& field, FoulState& state);

}  // namespace kelpie::sim
