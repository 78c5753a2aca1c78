// SPDX-License-Identifier: Apache-2.0
// How the body moved between two sensed ticks, by the joints alone: the paws and cowls that are on
// the ground in both roll there without slip. Which ones are is geometry, the body standing on its
// lowest; one whose paw is pressed counts even when it is not low. Wrong by what they slip and the
// body rolls; a robot that stands still does not move, whatever carries it.
#pragma once

#include <array>

#include "robot/body/Legs.h"
#include "robot/body/PlanarMotion.h"
#include "robot/core/types/Motion.h"

namespace kelpie::actuator {

// A sphere of a leg that may carry the body, and how its lower leg points.
struct SupportPlace {
  Point3<Robot> middle;
  Point3<Robot> legWay;  // of length 1, towards its tip
  double radius = 0.0;
  bool down = false;
};

struct FootMotionState {
  std::array<SupportPlace, body::kSupportCount> supports{};
  bool known = false;
};

// How the legs are in a tick, from which stance, odometry and log all take what they need.
struct SensedPose {
  body::AllTurns turns{};
  Stance stance;
};
SensedPose poseOf(const SensorFrame& sensors);

// Angles that are not finite give no motion.
body::PlanarMotion stepFootMotion(const SensorFrame& sensors, const SensedPose& pose,
                                  FootMotionState& state);
body::PlanarMotion stepFootMotion(const SensorFrame& sensors, FootMotionState& state);

}  // namespace kelpie::actuator
