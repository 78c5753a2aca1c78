// SPDX-License-Identifier: Apache-2.0
// Interrupts a decide() that does not end. It counts CPU seconds of the process, not the clock's: a
// busy machine must not change what a replay gives. Watchdog.cpp uses POSIX's virtual interval
// timer, whose signal Python turns into an exception (guard.py); another system links another file.
#pragma once

namespace kelpie::behaviour {

class Watchdog {
 public:
  explicit Watchdog(double seconds);  // starts to count
  ~Watchdog();                        // stops
  Watchdog(const Watchdog&) = delete;
  Watchdog& operator=(const Watchdog&) = delete;
};

}  // namespace kelpie::behaviour
