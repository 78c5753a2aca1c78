// SPDX-License-Identifier: Apache-2.0
#include "behaviour/watch/Watchdog.h"

#include <Python.h>
#include <sys/time.h>

#include <cerrno>
#include <csignal>

#include "behaviour/watch/HungScript.h"

namespace kelpie::behaviour {
namespace {

constexpr double kAgain = 0.02;  // s until the next interrupt, if a script caught the first one
// Interrupts that nobody heard, 2 s of them: a script in Python comes back within one or two.
constexpr int kDeaf = 100;

// A signal handler can reach nothing else.
volatile std::sig_atomic_t interrupts = 0;
volatile std::sig_atomic_t exitCode = 0;
PyThreadState* volatile thread = nullptr;

timeval timeOf(double seconds) {
  timeval time{};
  time.tv_sec = static_cast<time_t>(seconds);
  time.tv_usec = static_cast<suseconds_t>((seconds - static_cast<double>(time.tv_sec)) * 1e6);
  return time;
}

void interrupt(int /*signal*/) {
  const int before = errno;
  interrupts = interrupts + 1;
  if (interrupts > kDeaf) endHung(thread, exitCode);
  PyErr_SetInterruptEx(SIGVTALRM);
  errno = before;
}

}  // namespace

void Watchdog::listen() {
  struct sigaction action {};
  action.sa_handler = interrupt;
  action.sa_flags = SA_RESTART;
  sigaction(SIGVTALRM, &action, nullptr);
}

Watchdog::Watchdog(double seconds, int hungExit) {
  interrupts = 0;
  exitCode = hungExit;
  thread = PyThreadState_Get();
  const itimerval timer{timeOf(kAgain), timeOf(seconds)};
  setitimer(ITIMER_VIRTUAL, &timer, nullptr);
}

Watchdog::~Watchdog() {
  const itimerval off{};
  setitimer(ITIMER_VIRTUAL, &off, nullptr);
}

}  // namespace kelpie::behaviour
