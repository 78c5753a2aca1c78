// SPDX-License-Identifier: Apache-2.0
#include "behaviour/interpreter/Console.h"

extern "C" {
#include "behaviour/frozen/Steps.h"
}

namespace kelpie::behaviour {

void tell(const std::string& line) {
  const std::string whole = "behaviour: " + line + "\n";
  kelpieTell(whole.data(), whole.size());
}

}  // namespace kelpie::behaviour
