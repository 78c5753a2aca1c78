// SPDX-License-Identifier: Apache-2.0
// How far the legs swing of what they are told, by the speeds of their joints over about a step of
// walking. Servos with heavy gears swing further, weak ones less far, and the body goes with its
// feet: of turns at one speed on varied models it explains nine tenths of what they differ by.
// 0 while nothing has been walked lately; motions count for nothing.
#pragma once

#include <array>

#include "robot/core/Motion.h"

namespace kelpie::actuator {

// 0: as far as told; 0.1: a tenth further.
struct Reach {
  double front = 0.0;      // of the front rotators
  double hind = 0.0;       // of the hind rotators
  double shoulders = 0.0;  // of the front legs
};

// Squares of what the joints of front rotators, hind rotators and front shoulders move, rad2.
using LegPower = std::array<double, 3>;
LegPower movedBy(const JointAngles& from, const JointAngles& to);

struct ReachState {
  JointAngles felt;  // in the last tick
  LegPower asked{};  // low-passed
  LegPower done{};
};

// One tick: what the joints were told to move when they were told what they show now.
void stepReach(const LegPower& told, bool walks, const JointAngles& joints, ReachState& state);

Reach reachOf(const ReachState& state);

}  // namespace kelpie::actuator
