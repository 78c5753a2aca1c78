// SPDX-License-Identifier: Apache-2.0
// Whether the robot must rest for its power's sake, from what the battery and the pause switch said
// last. A cause that has ended counts on for a while: a battery recovers as soon as the robot lies,
// and would have it rise and fall in turn.
#pragma once

#include "robot/agent/PowerReport.h"
#include "robot/core/Motion.h"

namespace kelpie::agent {

struct PowerWatchParams {
  double settleSeconds = 1.0;    // from the end of a pause to standing up
  double batterySeconds = 30.0;  // so of a battery that was low, too hot or too hard at work
};

struct PowerWatchInput {
  TimeUs time;
  PowerReport report;
};

struct PowerWatchState {
  Rest rest = Rest::none;
  TimeUs until;  // the cause counts on
};

Rest step(const PowerWatchInput& in, const PowerWatchParams& params, PowerWatchState& state);

}  // namespace kelpie::agent
