// SPDX-License-Identifier: Apache-2.0
// The motors' life, decided once a message: powered without gains, then held joint by joint where
// they are, then free to play when a person has asked for it; and the way back: lie down, gains
// off, power off, and the end of the system where Sony's own objects end it. The start is the same
// after switching on, a pause, a jam and a rest: it begins with joints that nobody holds. Sony's
// samples MovingLegs7 and MovingHead7 send the sensed pose, wait for Ready and set the gains only
// then; its PowerMonitor switches off for the pause button and a low battery (openr-measured.md 5).
// Three rules hold in every phase. Power or a gain that is gone, and hands, begin anew from the
// sensed joints. A cause that takes the power wins over what the phase would do, and one that ends
// the system over every other. Power that the robot took away is asked for by a press of the head
// that began afterwards, until it comes or for 2 s.
// Keeps the phase; fails where the system never tells that the motors have power: the robot then
// stays as it is found, and shows it.
#pragma once

#include <array>

#include "robot/agent/joints/Causes.h"
#include "robot/core/types/Motion.h"

namespace kelpie::agent {

// What the OPEN-R object shall see to now.
struct MotorOrder {
  bool power = false;
  // Of each joint's standard proportional gain; 0: its gain is off.
  std::array<double, kJointCount> strength{};
  bool shutDown = false;  // the whole robot

  template <int = 0>
  static constexpr auto fields() {
    return fieldList(field("power", &MotorOrder::power),
                     field("strength", &MotorOrder::strength, "", 0, 1),
                     field("shutDown", &MotorOrder::shutDown));
  }
};

struct MotorsParams {
  double askSeconds = 2.0;         // for power that does not come
  double settleSeconds = 0.3;      // from power to the first gain: what was limp comes to rest
  std::uint32_t rampMessages = 4;  // until a joint has its full gain
  double gainSeconds = 3.0;        // at most for all gains, which take 0.7 s
  double lieSeconds = 6.0;         // at most, until the motors go off all the same
};

enum class MotorPhase : std::uint8_t { off, powered, gaining, waiting, plays, liesDown, ended };

struct MotorsIn {
  TimeUs time;
  PowerReport report;
  Cause cause;             // the gravest why it must not play
  std::uint32_t held = 0;  // bit i: joint i has a gain, as the OPEN-R object has seen to it
  bool asked = false;      // a person wants it to stand
  bool pressed = false;    // a hand is on the head
  bool lying = false;      // the legs have lain down
  bool lifted = false;     // somebody carries it
};

struct MotorsOut {
  Rest rest = Rest::starting;      // what the body does
  Rest reported = Rest::starting;  // why, for people
  MotorOrder order;
  bool tookPress = false;  // the hand on the head asks for power, and tells nothing of the game

  template <int = 0>
  static constexpr auto fields() {
    return fieldList(field("rest", &MotorsOut::rest, "", 0, kRestCount - 1),
                     field("reported", &MotorsOut::reported, "", 0, kRestCount - 1),
                     field("order", &MotorsOut::order), field("tookPress", &MotorsOut::tookPress));
  }
};

struct MotorsState {
  MotorPhase phase = MotorPhase::off;
  TimeUs since;                                       // the phase began
  Rest why = Rest::starting;                          // it does not play
  TimeUs askUntil;                                    // for power
  bool hadPower = false;                              // in the last message
  std::uint32_t held = 0;                             // so
  bool pressed = false;                               // so
  bool tookPress = false;                             // the press that is under way
  bool switchesOff = false;                           // for good
  std::array<std::uint32_t, kJointCount> messages{};  // that a joint has been held; 0: it is not
};

MotorsOut step(const MotorsIn& in, const MotorsParams& params, MotorsState& state);

}  // namespace kelpie::agent
