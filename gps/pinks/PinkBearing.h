// SPDX-License-Identifier: Apache-2.0
// A pink percept as what it is: a direction from the camera. Its distance is unknown, and the
// camera is up to 15 cm from the robot frame's origin, which is 4 deg for a wall 200 cm away.
#pragma once

#include <optional>

#include "gps/GpsIn.h"
#include "robot/core/types/WorldModel.h"

namespace kelpie::gps {

struct PinkBearing {
  Point2<Robot> eye;       // below the camera
  double eyeHeight = 0.0;  // cm, of the camera
  Angle heading;           // from there
  Angle elevation;         // the same
  double variance = 0.0;   // rad2, of the heading
  double area = 0.0;       // px
};
using PinkBearings = FixedVector<PinkBearing, 8>;

// Nothing for what is not finite or has no positive variance.
std::optional<PinkBearing> bearingOf(const PinkPercept& percept, const CameraPose& camera);

// All of a frame, largest first; those that cannot be used are counted.
PinkBearings bearingsOf(const GpsIn& in, GpsCounts& counts);

// The heading from the robot frame's origin when the patch is `distance` cm from there.
Angle headingAt(const PinkBearing& seen, double distance);

}  // namespace kelpie::gps
