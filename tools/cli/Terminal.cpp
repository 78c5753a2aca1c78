// SPDX-License-Identifier: Apache-2.0
#include "tools/cli/Terminal.h"

#include <fmt/core.h>
#include <unistd.h>

namespace kelpie::cli {

int fail(const std::string& message, int code) {
  fmt::print(stderr, "kelpie: {}\n", message);
  return code;
}

bool onTerminal() { return isatty(STDERR_FILENO) != 0; }

}  // namespace kelpie::cli
