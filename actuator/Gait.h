// SPDX-License-Identifier: Apache-2.0
// The trot: diagonal pairs swing in turn. A foot on the ground moves exactly as the body's rigid
// motion demands, tick by tick, so that no two feet drag each other; a foot in the air flies to
// where half of its next ground stroke lies ahead of its home. Limits: flat ground, kinematic.
#pragma once

#include "actuator/ActuatorParams.h"
#include "actuator/ActuatorState.h"
#include "robot/core/Command.h"

namespace kelpie::actuator {

// Where a foot stands when nothing moves; z = 0.
Point3<Robot> footHome(LegId leg, const StanceParams& stance);

// The request limited to the step length, then approached with bounded acceleration.
Velocity slewed(const Velocity& now, const WalkRequest& request, const ActuatorParams& params);

// One tick of walking or standing; leaves the feet's positions in the state.
void stepGait(const WalkRequest& request, const ActuatorParams& params, GaitState& state);

// Joint angles that bring the feet to their positions with the body carried as `stance` says.
void legsForFeet(const GaitState& state, const StanceParams& params, JointAngles& joints);

}  // namespace kelpie::actuator
