// SPDX-License-Identifier: Apache-2.0
// Where a standing robot is, roughly, by directions and sizes of the landmarks that it saw,
// whatever the camera's tilt. A search over the whole field: needs no start.
#pragma once

#include <optional>

#include "tools/calibrate/body/BodySightings.h"

namespace kelpie::calibrate {

// How many kinds of landmarks were seen, in at least two frames each.
std::size_t landmarkKinds(const Seen& seen);

// Nothing with fewer than two kinds.
std::optional<Pose2> startPlace(const StandingLog& log, const Seen& seen);

}  // namespace kelpie::calibrate
