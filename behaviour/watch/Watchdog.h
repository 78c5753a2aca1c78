// SPDX-License-Identifier: Apache-2.0
// Interrupts a decide() that does not end. It counts CPU seconds of the process, not the clock's: a
// busy machine must not change what a replay gives. Watchdog.cpp uses POSIX's virtual interval
// timer, whose signal Python turns into an exception (guard.py); another system links another file.
// Where Python does not look for signals, in a long call of its own, the process ends 2 s later
// (HungScript.h).
#pragma once

namespace kelpie::behaviour {

class Watchdog {
 public:
  Watchdog(double seconds, int hungExit);  // starts to count
  ~Watchdog();                             // stops
  Watchdog(const Watchdog&) = delete;
  Watchdog& operator=(const Watchdog&) = delete;

  static void listen();  // once, when the guard has instructed Python what to make of the signal
};

}  // namespace kelpie::behaviour
