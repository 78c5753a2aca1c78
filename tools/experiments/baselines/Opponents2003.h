// SPDX-License-Identifier: Apache-2.0
// The opponents' tracker of 2003 (checklist B-2.3.1.1), kept to repeat its failure: each sighting
// updates all four filters in information form, each by its share. The thesis does not print the
// shares; here they are how well each filter predicted the sighting. Fails by design: what one
// robot in sight adds to every filter draws all four to it.
#pragma once

#include "gps/GpsIn.h"
#include "gps/players/PlayersContext.h"
#include "gps/players/PlayersState.h"

namespace kelpie::gps {

// Time passes; own sightings are used, as seen from the pose. Read with extractOpponents().
void stepOpponents2003(const GpsIn& in, const PoseMode& pose, const PlayersContext& context,
                       Opponents& opponents);

}  // namespace kelpie::gps
