// SPDX-License-Identifier: Apache-2.0
// Where the four feet are at a phase of the step and a speed, and the leg angles that bring them
// there. A foot in its stroke moves as the ground does below a body that goes at that speed, turns
// included, so that no two feet drag each other. Limits: flat ground; nothing is remembered.
#pragma once

#include "actuator/walk/Phase.h"
#include "robot/core/Time.h"
#include "robot/core/types/Geometry.h"
#include "robot/core/types/Joints.h"

namespace kelpie::actuator {

// Speed of the robot frame over the ground.
struct Velocity {
  double forward = 0.0;  // cm/s
  double left = 0.0;     // cm/s
  double turn = 0.0;     // rad/s
};

// Where a foot stands when nothing moves; z = 0.
Point3<Robot> footHome(LegId leg, const StanceParams& stance);

// Where it is now.
Point3<Robot> footPlace(LegId leg, const WalkSet& set, const Velocity& velocity,
                        const PhaseState& phase);

// The legs of `joints` so that the feet are where they shall be, the body carried as the set says.
void setLegs(const WalkSet& set, const Velocity& velocity, const PhaseState& phase,
             JointAngles& joints);

}  // namespace kelpie::actuator
