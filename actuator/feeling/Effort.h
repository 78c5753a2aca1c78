// SPDX-License-Identifier: Apache-2.0
// How hard the legs work, and whether they should be spared: the mean over one step of the largest
// leg duty, from which the localiser tells being stuck (thesis 2004 section 2.2.4); and the switch
// to weak joints when the battery gives much current for long (same section, checklist B-2.2.4.5).
// Limits: knows duty only while the robot walks without a break for half a step.
#pragma once

#include "actuator/ActuatorParams.h"
#include "robot/core/types/Motion.h"

namespace kelpie::actuator {

// Duty of the hardest working leg joint in each tick of walking without a break.
struct EffortState {
  std::array<double, 128> duty{};  // a ring; a step has at most 120 ticks
  std::uint32_t ticks = 0;         // walked, all in all
};

struct GainState {
  bool low = false;
  double current = 0.0;  // mA, running mean
};

// Takes the sensed ticks of one message; forgets all of them when the robot does not walk.
void recordEffort(const MotionInput& in, bool walking, EffortState& state);

// Mean over the last step, 0 to 1; 0 until half a step has been walked. A duty that is not finite
// counts as none, one beyond full as full.
double effort(const EffortState& state, const GaitParams& gait);

// Low after the mean current is above one bound, until it is below another.
void stepGain(double current, const GainParams& params, GainState& state);

}  // namespace kelpie::actuator
