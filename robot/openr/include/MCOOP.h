// SPDX-License-Identifier: Apache-2.0
// The few calls of the system layer below OPEN-R that objects use: who am I, what time is it.
#pragma once

#include "Types.h"

struct SystemTime {
  longword seconds;
  longword useconds;
};
static_assert(sizeof(SystemTime) == 8, "two longwords");

using sError = longword;
constexpr sError sSUCCESS = 0;

// Time since the start of the robot, or of the simulated world.
sError GetSystemTime(SystemTime* time);
sError WhoAmI(OID* self);
