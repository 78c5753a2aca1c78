// SPDX-License-Identifier: Apache-2.0
// Why a robot must not play, and what that demands of it: each cause by itself, since one that ends
// must not end another. A cause that is over counts on for a while: a battery recovers as soon as
// the robot lies, and would have it rise and fall in turn. Of those that count the gravest is
// reported. The pause switch switches the robot off once it has been held without a break for so
// long. Fails where the switch's bit flickers while a hand holds it: the robot then only lies.
#pragma once

#include <array>
#include <optional>

#include "robot/agent/joints/PowerReport.h"
#include "robot/core/types/Motion.h"

namespace kelpie::agent {

// The more, the graver.
enum class Demand : std::uint8_t { nothing, lie, noPower, switchOff };

struct Cause {
  Rest rest = Rest::none;
  Demand demand = Demand::nothing;
};

struct CausesParams {
  double pauseHoldSeconds = 3.0;  // of the pause switch, until the robot is switched off
  double settleSeconds = 1.0;     // from the end of a pause to standing up
  double batterySeconds = 30.0;   // so of a battery that was low, too hot or too hard at work
};

struct CausesIn {
  TimeUs time;
  PowerReport report;
  bool stuck = false;  // a joint does not follow
  bool blind = false;  // no image comes
};

struct CausesState {
  std::array<std::optional<TimeUs>, kRestCount> until{};  // each counts on; none: it does not
  std::optional<TimeUs> pausedSince;                      // the switch is held
};

// The gravest cause that counts now.
Cause step(const CausesIn& in, const CausesParams& params, CausesState& state);

}  // namespace kelpie::agent
