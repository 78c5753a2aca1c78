// SPDX-License-Identifier: Apache-2.0
// What the programs say to whoever started them.
#pragma once

#include <string>

namespace kelpie::cli {

// Exit codes of every program.
constexpr int kExitDone = 0;
constexpr int kExitCheckFailed = 1;
constexpr int kExitBadInput = 2;
constexpr int kExitMachine = 3;        // disk, memory, network, or a process that died
constexpr int kExitInterrupted = 130;  // as shells have it for Ctrl-C

// Prints "kelpie: message" to standard error and returns `code`.
int fail(const std::string& message, int code);
// Whether progress may be drawn: standard error is a terminal.
bool onTerminal();

}  // namespace kelpie::cli
