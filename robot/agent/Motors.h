// SPDX-License-Identifier: Apache-2.0
// The motors' life, decided once a message: powered without gains, then held joint by joint where
// they are, then free to play when a person has asked for it; and the way back: lie down, gains
// off, power off, and the end of the system where Sony's own objects end it. The start is the same
// after switching on, a pause, a jam and a rest: it begins with joints that nobody holds. Sony's
// samples MovingLegs7 and MovingHead7 send the sensed pose, wait for Ready and set the gains only
// then; its PowerMonitor switches off for the pause button and a low battery (openr-measured.md 5).
// Keeps the phase; fails where the system never tells that the motors have power: the robot then
// stays as it is found.
#pragma once

#include <array>

#include "robot/agent/PowerWatch.h"
#include "robot/core/Motion.h"

namespace kelpie::agent {

// What the OPEN-R object shall see to now.
struct MotorOrder {
  bool power = false;
  // Of each joint's standard proportional gain; 0: its gain is off.
  std::array<double, kJointCount> strength{};
  bool shutDown = false;  // the whole robot

  static constexpr auto fields() {
    return fieldList(field("power", &MotorOrder::power),
                     field("strength", &MotorOrder::strength, "", 0, 1),
                     field("shutDown", &MotorOrder::shutDown));
  }
};

struct MotorsParams {
  double settleSeconds = 0.3;      // from power to the first gain: what was limp comes to rest
  std::uint32_t rampMessages = 4;  // until a joint has its full gain
  double pauseHoldSeconds = 3.0;   // of the pause switch, until the robot is switched off
  double lieSeconds = 6.0;         // at most, until the motors go off all the same
};

enum class MotorPhase : std::uint8_t { off, powered, gaining, waiting, plays, liesDown, ended };

struct MotorsIn {
  TimeUs time;
  PowerReport report;
  Rest cause = Rest::none;  // why it must not play, of those for which it lies down
  std::uint32_t held = 0;   // bit i: joint i has a gain, as the OPEN-R object has seen to it
  bool asked = false;       // a person wants it to stand
  bool pressed = false;     // the head, in this message: asks again after an end
  bool lying = false;       // the legs have lain down
  bool lifted = false;      // somebody carries it
};

struct MotorsOut {
  Rest rest = Rest::starting;
  MotorOrder order;

  static constexpr auto fields() {
    return fieldList(field("rest", &MotorsOut::rest, "", 0, kRestCount - 1),
                     field("order", &MotorsOut::order));
  }
};

struct MotorsState {
  MotorPhase phase = MotorPhase::off;
  TimeUs since;                                       // the phase began
  TimeUs freeAt;                                      // when there was no cause to rest last
  Rest why = Rest::starting;                          // shown until it plays
  std::array<std::uint32_t, kJointCount> messages{};  // that a joint has been held; 0: it is not
};

MotorsOut step(const MotorsIn& in, const MotorsParams& params, MotorsState& state);

}  // namespace kelpie::agent
