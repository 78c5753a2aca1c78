// SPDX-License-Identifier: Apache-2.0
// Where in the step the robot is. The phase only ever goes on, so that a change of speed, direction
// or walk never makes a foot step back; what fades in and out as the robot begins and ends to walk
// is the lift.
#pragma once

#include "actuator/walk/WalkSet.h"
#include "robot/core/types/Joints.h"

namespace kelpie::actuator {

struct PhaseState {
  double phase = 0.0;  // of the step: 0 to 1, left front and right hind foot come down at 0
  double lift = 0.0;   // 0 standing, 1 walking
};

// One tick; `walking`: the feet shall step.
void stepPhase(bool walking, const GaitParams& gait, PhaseState& state);

inline bool standing(const PhaseState& state) { return state.lift == 0.0; }

// That of one foot, 0 where its stroke begins.
double footPhase(LegId leg, const GaitParams& gait, const PhaseState& state);

}  // namespace kelpie::actuator
