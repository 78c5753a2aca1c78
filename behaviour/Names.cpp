// SPDX-License-Identifier: Apache-2.0
// Prints the stand-in for the module `kelpie`: behaviour_names > tests/py/kelpie.py
#include <cstdio>

#include "behaviour/KelpieModule.h"

int main() {
  std::fputs(kelpie::behaviour::kelpieStandInText().c_str(), stdout);
  return 0;
}
