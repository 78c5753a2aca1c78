// SPDX-License-Identifier: Apache-2.0
// How the body moved between two sensed ticks, by the joints alone: the feet that are on the ground
// in both keep their places. Which ones are is geometry, the body standing on its lowest feet; a
// foot whose paw is pressed counts even when it is not low. Wrong by what the feet slip and the
// body rolls; a robot that stands still does not move, whatever carries it.
#pragma once

#include <array>

#include "robot/body/PlanarMotion.h"
#include "robot/core/Motion.h"

namespace kelpie::actuator {

struct FootMotionState {
  std::array<Point3<Robot>, kLegCount> feet{};
  std::array<bool, kLegCount> down{};
  bool known = false;
};

// Angles that are not finite give no motion.
body::PlanarMotion stepFootMotion(const SensorFrame& sensors, FootMotionState& state);

}  // namespace kelpie::actuator
