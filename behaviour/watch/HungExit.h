// SPDX-License-Identifier: Apache-2.0
// The exit codes of a process on a PC whose script is where nothing breaks it off: in one long call
// of Python's own (HungScript.h).
#pragma once

namespace kelpie::behaviour {

constexpr int kHungExit = 4;      // in decide(): a new process may play on
constexpr int kHungLoadExit = 2;  // while it loads or answers a tool: it would be so again

}  // namespace kelpie::behaviour
