// SPDX-License-Identifier: Apache-2.0
// What is believed of the other players, once the pose is published: opponents, team mates, what
// stands where, the team's ball, and the message to the team.
#pragma once

#include "gps/GpsIn.h"
#include "gps/players/PlayersContext.h"
#include "gps/players/PlayersState.h"

namespace kelpie::gps {

// Adds it to `world`, which holds the pose and the ball.
void stepPlayers(const GpsIn& in, const PlayersContext& context, PlayersState& players,
                 GpsCounts& counts, WorldModel& world);

}  // namespace kelpie::gps
