// SPDX-License-Identifier: Apache-2.0
// What each key asks of the robot, as one table, and keys that were written down beforehand: lines
// of a time and a key. A line that is no such thing is an error that names it; nothing is guessed.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "robot/core/Expected.h"
#include "robot/core/types/Command.h"

namespace kelpie::teleop {

// What a key does beyond steps and motions.
enum class KeyAct : std::uint8_t { step, motion, hold, stop, lookAhead, mouth, getUp, quit };

struct KeyBinding {
  char key;
  const char* word;  // its other name in a file, "" for none
  KeyAct act;
  int forward = 0;  // steps of the walk
  int left = 0;
  int turn = 0;
  int pan = 0;  // steps of the head
  int tilt = 0;
  MotionKind motion = MotionKind::none;
};

// Null for a key that means nothing.
const KeyBinding* bindingOf(char key);

// The key of a word: the key itself, or "up", "down", "left", "right", "space". 0: there is none.
char keyOf(const std::string& word);

// Takes the first key out of what a terminal sent, arrows included. 0: none that means something;
// an arrow of which only a part has come stays in the buffer.
char takeKey(std::string& typed);

struct TimedKey {
  double seconds;
  char key;
};

// Lines "TIME KEY", times in seconds that do not fall; what follows # is a comment. `name` stands
// in the error.
Expected<std::vector<TimedKey>> readKeys(const std::string& text, const std::string& name);

// Lines of help, of at most 100 letters.
std::vector<std::string> keyHelp();

}  // namespace kelpie::teleop
