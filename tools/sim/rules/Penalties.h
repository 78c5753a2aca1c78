// SPDX-License-Identifier: Apache-2.0
// Robots off the field: where they wait, how long, and where they come back. A penalty's time runs
// in every state of the match; nobody comes back in set, and half-time ends all penalties. Who
// walks away from its waiting place is carried back to it.
#pragma once

#include <array>

#include "tools/sim/rules/Fouls.h"

namespace kelpie::sim {

struct Penalty {
  bool off = false;
  TimeUs until;
  Offence offence = Offence::ownBox;
};

struct PenaltyState {
  std::array<Penalty, kMaxRobots> of;

  double secondsLeft(std::size_t player, TimeUs now) const;
};

// Beside the left side line of the red team's field, one place for each robot, beside the own half.
Pose2 waitingPlace(const body::FieldDescription& field, const ScenePlayer& player);
// On the half-way line's end that is farther from the ball, looking across the field; where
// somebody stands, farther back beside the own half.
Pose2 returnPlace(const body::FieldDescription& field, const MatchScene& scene, std::size_t player);

struct PenaltyOut {
  FixedVector<std::size_t, kMaxRobots> back;   // they play again
  FixedVector<std::size_t, kMaxRobots> stray;  // they are not where they should wait
};

PenaltyOut step(const MatchScene& scene, PlayState play, const body::FieldDescription& field,
                PenaltyState& state);

}  // namespace kelpie::sim
