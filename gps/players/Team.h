// SPDX-License-Identifier: Apache-2.0
// What team mates say: which messages are believed, and what this robot says itself. A message with
// anything in it that cannot be is refused whole and counted.
#pragma once

#include "gps/players/PlayersContext.h"
#include "gps/players/PlayersState.h"
#include "robot/core/types/FrameInput.h"

namespace kelpie::gps {

// Everything finite, on or near the field, of positive variance, and not too old.
bool believable(const TeamMessage& message, const body::FieldDescription& field,
                const TeamParams& params);

// Keeps the newest message of each mate; ages and forgets. Answers with those of this frame.
FixedVector<TeamMessage, kTeammates> hear(const FrameInput& input, const PlayersContext& context,
                                          Teammates& mates, GpsCounts& counts);

FixedVector<TeammateEstimate, kTeammates> extractMates(const TeamParams& params,
                                                       const Teammates& mates);

// Makes a new message when the last one is old enough, sooner when its note has news for the mates.
void speak(const FrameInput& input, const WorldModel& world, const PlayersContext& context,
           PlayersState& players);

}  // namespace kelpie::gps
