// SPDX-License-Identifier: Apache-2.0
// Prints the stand-in for the module `kelpie`: for tests/py, which finds it in the build folder
#include <cstdio>

#include "behaviour/views/KelpieModule.h"

int main() {
  std::fputs(kelpie::behaviour::kelpieStandInText().c_str(), stdout);
  return 0;
}
