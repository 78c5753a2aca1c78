// SPDX-License-Identifier: Apache-2.0
// What was told last of a script that went wrong: each different error once (README.md).
#pragma once

#include <cstdint>
#include <string>

namespace kelpie::behaviour {

struct Complaint {
  std::uint32_t number = 0;  // of those told so far
  std::string line;
};

}  // namespace kelpie::behaviour
