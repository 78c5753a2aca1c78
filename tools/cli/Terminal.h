// SPDX-License-Identifier: Apache-2.0
// What the programs say to whoever started them.
#pragma once

#include <string>

namespace kelpie::cli {

// Exit codes of every program.
constexpr int kDone = 0;
constexpr int kCheckFailed = 1;
constexpr int kBadInput = 2;

// Prints "kelpie: message" to standard error and returns `code`.
int complain(const std::string& message, int code);
// Whether progress may be drawn: standard error is a terminal.
bool onTerminal();

}  // namespace kelpie::cli
