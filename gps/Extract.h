// SPDX-License-Identifier: Apache-2.0
// What of the state the rest of the agent gets to see: the heaviest mode as the pose (thesis 2004
// section 2.1.5), the other modes, the slow states beside them, the ball on the field. The players
// are added by stepPlayers().
#pragma once

#include "gps/GpsParams.h"
#include "gps/GpsState.h"

namespace kelpie::gps {

void extractInto(WorldModel& world, const GpsState& state, const GpsParams& params);
WorldModel extract(const GpsState& state, const GpsParams& params);

}  // namespace kelpie::gps
