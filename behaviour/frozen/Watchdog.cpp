// SPDX-License-Identifier: Apache-2.0
// Counts the interpreter's steps in place of CPU seconds. There is nobody to end a long call of
// Python's own (docs/python-on-robot.md).
#include "behaviour/watch/Watchdog.h"

#include <algorithm>
#include <cstdint>

extern "C" {
#include "behaviour/frozen/Steps.h"
}

namespace kelpie::behaviour {
namespace {

// A step takes some 1500 instructions in a small loop and 2600 in decide(), whose dearest frame
// takes 929 steps (docs/python-on-robot.md); 576 million pass in a second where no cache misses.
constexpr double kStepsPerSecond = 3e5;
constexpr std::uint32_t kAgain = 6000;  // as 0.02 s, if a script caught the first interrupt

}  // namespace

void Watchdog::listen() {}

Watchdog::Watchdog(double seconds, int /*hungExit*/) {
  const double steps = std::max(1.0, seconds * kStepsPerSecond);
  kelpieLimitSteps(static_cast<std::uint32_t>(steps), kAgain);
}

Watchdog::~Watchdog() { kelpieLimitSteps(0, 0); }

}  // namespace kelpie::behaviour
