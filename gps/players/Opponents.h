// SPDX-License-Identifier: Apache-2.0
// The four opponents, each a Gaussian over its place on the field in information form (thesis 2004
// section 2.3). A sighting goes to one filter only, chosen by the angle: updating all of them made
// all four come together on the one robot in sight. What a team mate saw is added as information.
// Fails when two opponents cross unseen (they are not distinguished), and with a wrong own pose.
#pragma once

#include "gps/GpsIn.h"
#include "gps/OnField.h"
#include "gps/players/PlayersContext.h"
#include "gps/players/PlayersState.h"

namespace kelpie::gps {

// Time passes; own sightings are used, as seen from the pose.
void stepOpponents(const GpsIn& in, const PoseMode& pose, const PlayersContext& context,
                   Opponents& opponents, GpsCounts& counts);

// What one message of a team mate tells.
void hearOpponents(const TeamMessage& message, const PlayersContext& context, Opponents& opponents);

// What the own sightings tell that no message has sent yet; forgets them.
FixedVector<SharedOpponent, kOpponents> takeUnsent(Opponents& opponents);

FixedVector<OpponentEstimate, kOpponents> extractOpponents(const Opponents& opponents);

// Where an opponent likely is when nothing is known of it (facts-2005 section 5.4).
Place startPlace(std::size_t index, const PlayersContext& context);

// On the field, with the pose's own uncertainty; `factor` times the percept's variances.
Place sightingOf(const RobotPercept& percept, const PoseMode& pose, double factor);

}  // namespace kelpie::gps
