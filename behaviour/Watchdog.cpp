// SPDX-License-Identifier: Apache-2.0
#include "behaviour/Watchdog.h"

#include <sys/time.h>

namespace kelpie::behaviour {
namespace {

constexpr double kAgain = 0.02;  // s until the next interrupt, if a script caught the first one

timeval timeOf(double seconds) {
  timeval time{};
  time.tv_sec = static_cast<time_t>(seconds);
  time.tv_usec = static_cast<suseconds_t>((seconds - static_cast<double>(time.tv_sec)) * 1e6);
  return time;
}

}  // namespace

Watchdog::Watchdog(double seconds) {
  const itimerval timer{timeOf(kAgain), timeOf(seconds)};
  setitimer(ITIMER_VIRTUAL, &timer, nullptr);
}

Watchdog::~Watchdog() {
  const itimerval off{};
  setitimer(ITIMER_VIRTUAL, &off, nullptr);
}

}  // namespace kelpie::behaviour
