// SPDX-License-Identifier: Apache-2.0
// The few calls of the system layer below OPEN-R that objects use: who am I, what time is it. They
// are C functions on the robot (openr-measured.md 2). Which value of a SystemTime is the invalid
// one is not documented; here it is UNDEF in both halves.
#pragma once

#include "Types.h"

struct SystemTime {
  longword seconds;
  longword useconds;

  SystemTime() { MakeInvalid(); }
  SystemTime(longword wholeSeconds, longword microseconds)
      : seconds(wholeSeconds), useconds(microseconds) {}

  void MakeInvalid() { seconds = useconds = UNDEF; }
  bool IsValid() const { return seconds != UNDEF || useconds != UNDEF; }
};
static_assert(sizeof(SystemTime) == 8, "two longwords");

using sError = slongword;
constexpr sError sSUCCESS = 0;

extern "C" {
// Time since the start of the robot, or of the simulated world.
sError GetSystemTime(SystemTime* time);
sError WhoAmI(OID* self);
}
