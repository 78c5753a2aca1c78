// SPDX-License-Identifier: Apache-2.0
// What the body feels of the world, from the sensors and what was commanded: how much of the feet's
// push does not move the body, from that whether something holds the robot; on which side it lies;
// a front paw that pushes into something while its foot is in the air.
// Over a whole step the feet's push (ContactForce.h) and the accelerometer, which tells gravity and
// what the body did, balance by Newton's law in any walk; what is left, something else does.
// Limits: knows nothing until a step has been walked, of a robot that stands, and when the feet
// hardly move. Who has fallen is not stuck.
#pragma once

#include "actuator/feeling/ContactForce.h"
#include "actuator/feeling/Falls.h"
#include "actuator/feeling/FeelingParams.h"
#include "actuator/feeling/Lifted.h"
#include "actuator/walk/Walk.h"

namespace kelpie::actuator {

// One tick of walking: what was felt, and what was commanded then.
struct FeltTick {
  double current = 0.0;            // mean of the rotators
  ContactForce resisted;           // what of the feet's push did not move the body
  Velocity feet;                   // commanded
  std::array<bool, 2> airborne{};  // left and right front foot, as commanded
};

struct FeelingState {
  FallState falls;
  LiftState lift;
  std::array<SensedLegs, 2> before{};  // the last tick and the one before
  std::array<FeltTick, 192> felt{};    // a ring: a step of at most 120 ticks and the delay
  std::uint32_t ticks = 0;             // walked without a break
  double loadedSeconds = 0.0;
  bool stuck = false;
  std::array<std::uint32_t, 2> pressed{};  // ticks in a row, in the air
  std::array<double, 2> blockedSeconds{};  // that are left
};

// What load a walk shows without anything in its way, its feet moving so.
double freeLoad(const Velocity& feet, const FreeLoad& params);

struct Legs {
  Footing footing = Footing::other;
  bool walk = false;
};

// One message. `walk` as it was commanded until now.
Feeling feel(const MotionInput& in, const WalkState& walk, Legs legs, const FeelingParams& params,
             FeelingState& state);

}  // namespace kelpie::actuator
