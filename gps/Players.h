// SPDX-License-Identifier: Apache-2.0
// Everything that needs the published pose: the ball's place on the field, team mates, opponents,
// the team's ball, and the message to the team.
#pragma once

#include "gps/Localiser.h"

namespace kelpie::gps {

void stepPlayers(const GpsIn& in, const GpsParams& params, GpsState& state, WorldModel& world);

}  // namespace kelpie::gps
