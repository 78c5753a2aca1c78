// SPDX-License-Identifier: Apache-2.0
// Basic types of ANT, the robot's network (openr.md 5.7). Of its errors only the number of success
// is documented: anything else is a failure.
#pragma once

#include "Types.h"

using int32 = std::int32_t;
using uint32 = std::uint32_t;

enum antError { ANT_SUCCESS = 0, ANT_FAIL = 1 };

// What an Extra entry gets as a reply.
using ANTENVMSG = void*;
