// SPDX-License-Identifier: Apache-2.0
// Whether somebody has lifted the robot off the ground: all paws are free for longer than what the
// legs do on the ground explains, and the accelerometer has measured a movement since the last paw.
// What explains it differs: who stands, walks or has pressed a paw on the way up presses one soon
// again; who gets up does so within a second; who lies presses none, but is still once it
// has settled.
// It stands again when a paw is pressed and the accelerometer has been still for a while; without a
// paw, as on its belly with slack legs, after a longer while, on a side or its back after a long
// one. Twice so without a paw, and the switches are not believed before one closes.
// Limits: a robot that kicks is not seen to be lifted, nor is one whose switches never closed. A
// fall looks like a turn in somebody's hands: who lifts the robot and turns it over within a
// quarter of a second sees it get up for a second before it is slack.
#pragma once

#include <array>

#include "actuator/feeling/FeelingParams.h"
#include "robot/core/types/Motion.h"

namespace kelpie::actuator {

// What the legs do, by what their paws tell of it.
enum class Footing : std::uint8_t { other, stands, standsUp, lies, getsUp };

struct LiftState {
  bool lifted = false;
  bool believed = false;                           // the switches close at all
  std::uint8_t blindly = 0;                        // times put down since a paw was pressed
  Footing footing = Footing::other;                // in the last message
  double footed = 0.0;                             // s, with this footing
  bool pressed = false;                            // a paw, so
  bool rested = false;                             // it has been still, so
  bool moved = false;                              // since then
  double free = 0.0;                               // s, of all paws
  double still = 0.0;                              // s
  std::array<double, 3> resting{0.0, 0.0, 981.0};  // cm/s2, low passed
};

// One message.
void stepLifted(const MotionInput& in, Footing footing, const LiftParams& params, LiftState& state);

}  // namespace kelpie::actuator
