// SPDX-License-Identifier: Apache-2.0
// The end of the carpet as a sighting of the camera's tilt: from a pose that is known the direction
// to it tells how far it is, and so how high it is seen. At 300 cm a pose that is 5 cm wrong moves
// it by 0.07 deg. Wrong where a robot or a wall passes for it; most such lie outside the gate.
#pragma once

#include "gps/GpsIn.h"
#include "gps/camera/Tilt.h"
#include "robot/body/FieldDescription.h"

namespace kelpie::gps {

// Two of each border in the image, seen from a mode; none from a mode that is too wide, and none of
// what is near, which tells the pose rather than the tilt.
TiltSightings edgeSightings(const GpsIn& in, const body::FieldDescription& field,
                            const TiltParams& params, const PoseMode& mode);

}  // namespace kelpie::gps
