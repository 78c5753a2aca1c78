// SPDX-License-Identifier: Apache-2.0
// The four opponents, each a Gaussian over its place on the field in information form (thesis 2004
// section 2.3). A sighting goes to one filter only, chosen by the angle: updating all of them made
// all four come together on the one robot in sight. What a team mate saw is added as information.
// Fails when two opponents cross unseen (they are not told apart), and with a wrong own pose.
#pragma once

#include "gps/Localiser.h"

namespace kelpie::gps {

// Time passes; own sightings are used.
void stepOpponents(const GpsIn& in, const GpsParams& params, GpsState& state);

// What one message of a team mate tells.
void hearOpponents(const TeamMessage& message, const GpsParams& params, GpsState& state);

// What the own sightings since the last message tell, which no message has sent; forgets them.
FixedVector<SharedOpponent, kOpponents> takeUnsent(PlayersState& players);

FixedVector<OpponentEstimate, kOpponents> extractOpponents(const PlayersState& players);

}  // namespace kelpie::gps
