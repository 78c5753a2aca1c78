// SPDX-License-Identifier: Apache-2.0
// A Command's trace in words: on films and pictures, by `kelpie why` and `kelpie tree`. Whatever a
// log holds, the words are printable: bytes that are no UTF-8 and control characters become '?'.
#pragma once

#include <string>
#include <vector>

#include "robot/core/types/Command.h"

namespace kelpie::match {

const char* wordFor(TraceLayer layer);  // "player"
// 83.4 -> "83", 8.26 -> "8.3", 0.127 -> "0.13": as much as a person wants to know.
std::string shortNumber(double number);
// Every {} is filled with the next number, with ? where there is none.
std::string reasonOf(const TraceStep& step);
// "grab_dribble: aim - the gap is 12 deg to the left", for pictures.
std::string lineOf(const TraceStep& step);
// "The skill grab_dribble chose aim: the gap is 12 deg to the left."
std::string sentenceOf(const TraceStep& step);
// "forward: play > attacker: attack > grab_dribble: aim": what was chosen, without the reasons.
std::string chainOf(const Trace& trace);

// What the body is asked for, as the end of a sentence: "walk 12 cm/s ahead and turn 20 deg/s to
// the left, with the head 5 deg to the right and 10 deg down".
std::string requestOf(const Command& command);
// Who decided in place of the behaviours, and why; empty where they did.
std::string insteadOf(bool driven, const Command& command);
// For pictures: that, or a line for each step of the trace.
std::vector<std::string> reasonLines(bool driven, const Command& command);

}  // namespace kelpie::match
