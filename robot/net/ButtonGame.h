// SPDX-License-Identifier: Apache-2.0
// The match as people tell it to a robot by its buttons, where no game controller is heard (rule
// book of 2005: it must be possible without wireless; holds and thresholds facts-2005 section 8.3).
//
//   a press of head or back   initial -> ready -> set -> playing; penalised -> playing
//   the back for 1 s          ready, set or playing -> penalised, while it is still held
//   the head for 3 s          -> initial, while it is still held
//
// A press counts when it ends, after at least 0.1 s and before it became one of the long ones.
// Finished and the scores are not given by buttons. A hand that lifts a robot by its back presses
// it too: `backAdvances` off leaves the advance to the head alone, as the rule book has it.
#pragma once

#include "robot/core/types/FrameInput.h"

namespace kelpie::net {

struct ButtonParams {
  double press = 0.1;        // s that a button must be held to count
  double penaltyHold = 1.0;  // s of the back
  double resetHold = 3.0;    // s of the head
  double headThreshold =
      10;  // of the head's sensor; the back's switches are closed at 15 of theirs
  bool backAdvances = true;

  template <int = 0>
  static constexpr auto fields() {
    using P = ButtonParams;
    return fieldList(field("press", &P::press, "s", 0, 10),
                     field("penaltyHold", &P::penaltyHold, "s", 0, 60),
                     field("resetHold", &P::resetHold, "s", 0, 60),
                     field("headThreshold", &P::headThreshold, "", 0, 100),
                     field("backAdvances", &P::backAdvances));
  }
};

struct ButtonIn {
  TimeUs time;
  SensorFrame sensors;
};

struct ButtonState {
  struct Button {
    bool down = false;
    TimeUs since;
  };
  PlayState play = PlayState::initial;
  bool penalised = false;
  Button head;
  Button back;
};

struct ButtonGame {
  PlayState state = PlayState::initial;
  bool penalised = false;
};

ButtonGame step(const ButtonIn& in, const ButtonParams& params, ButtonState& state);

}  // namespace kelpie::net
