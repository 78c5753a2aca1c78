// SPDX-License-Identifier: Apache-2.0
// Where the host's lines for people go: Console.cpp has standard error, frozen/Console.cpp the
// memory that stands for it where there is none.
#pragma once

#include <string>

namespace kelpie::behaviour {

void tell(const std::string& line);  // "behaviour: LINE"

}  // namespace kelpie::behaviour
