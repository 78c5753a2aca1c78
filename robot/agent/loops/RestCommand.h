// SPDX-License-Identifier: Apache-2.0
// What a robot is asked for that rests: of its body nothing, of its lights the reason. What the
// behaviours think of the world goes on.
#pragma once

#include "robot/body/Lights.h"
#include "robot/core/types/Command.h"

namespace kelpie::agent {

inline Command restCommand(const Command& asked, const GameState& game, Rest rest) {
  Command command = asked;
  command.walk = {};
  command.head = {};
  command.mouthOpen = false;
  command.ears = {};
  command.motion = MotionKind::none;
  command.leds = body::lights(game, rest);
  return command;
}

}  // namespace kelpie::agent
