// SPDX-License-Identifier: Apache-2.0
// With what force the feet push the ground, from the currents of the leg joints. Current is torque,
// the duty less what the joint's speed gives back: the duty of the hardest joint is full in any
// walk (physics.md section 5). A foot's force is what does the same work as its three joints.
// Limits: what a leg's own weight and gears take counts as its foot's; a body that rests on its
// forearms or belly pushes unseen. Near a straight leg the force along it is underestimated.
#pragma once

#include "robot/body/Legs.h"
#include "robot/core/types/Motion.h"

namespace kelpie::actuator {

constexpr std::size_t kFirstLegJoint = index(Joint::leftFrontRotator);
constexpr std::size_t kJointsOfLegs = 3 * kLegCount;

// The legs as one tick sensed them.
struct SensedLegs {
  std::array<double, kJointsOfLegs> angle{};  // rad
  std::array<double, kJointsOfLegs> duty{};   // -1 to 1
};

// What is not finite is as it was before.
SensedLegs sensedLegs(const SensorFrame& tick, const SensedLegs& before);

// Of the tick in the middle, whose speeds are known from both sides: -1 to 1 of the greatest.
using LegCurrents = std::array<double, kJointsOfLegs>;
LegCurrents legCurrents(const SensedLegs& last, const SensedLegs& middle, const SensedLegs& next,
                        double noLoad);

// Mean size of the four rotators' currents.
double rotatorCurrent(const LegCurrents& currents);

// All feet together, on the ground, in the torso's axes: shares of a joint's greatest torque for
// a cm; the turn about the middle of the body, to the left, in shares of that torque.
struct ContactForce {
  double forward = 0.0;
  double left = 0.0;
  double turn = 0.0;
};
ContactForce contactForceOf(const LegCurrents& currents, const SensedLegs& legs);

}  // namespace kelpie::actuator
