// SPDX-License-Identifier: Apache-2.0
// How far the legs swing of what is commanded, by the speeds of their joints over about a step of
// walking. Servos with heavy gears swing further, weak ones less far, and the body goes with its
// feet: of turns on varied models the reach of all joints explains nine tenths of what they differ
// by, that of the front rotators alone half.
// 0 while nothing has been walked recently; motions count for nothing.
#pragma once

#include <array>

#include "actuator/walk/SideReach.h"
#include "robot/core/types/Motion.h"

namespace kelpie::actuator {

// 0: as far as commanded; 0.1: a tenth further.
struct Reach {
  SideReach left;
  SideReach right;
};

// Squares of what the legs' joints move, rad2, in the order of robot/core/types/Joints.h.
using LegPower = std::array<double, 3 * kLegCount>;
LegPower movedBy(const JointAngles& from, const JointAngles& to);

struct ReachState {
  JointAngles felt;  // in the last tick
  LegPower asked{};  // low-passed
  LegPower done{};
};

// One tick: what the joints were commanded to move when what they show now was commanded.
void stepReach(const LegPower& commanded, bool walks, const JointAngles& joints, ReachState& state);

Reach reachOf(const ReachState& state);

}  // namespace kelpie::actuator
