// SPDX-License-Identifier: Apache-2.0
#include "behaviour/interpreter/Console.h"

#include <cstdio>

namespace kelpie::behaviour {

void tell(const std::string& line) { std::fprintf(stderr, "behaviour: %s\n", line.c_str()); }

}  // namespace kelpie::behaviour
