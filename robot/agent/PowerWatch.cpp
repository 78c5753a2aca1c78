// SPDX-License-Identifier: Apache-2.0
#include "robot/agent/PowerWatch.h"

namespace kelpie::agent {
namespace {

Rest causeIn(const PowerReport& report, bool powered) {
  if (report.paused) return Rest::paused;
  if (powered && !report.motorPower) return Rest::powerless;
  return report.batteryLow ? Rest::batteryLow : Rest::none;
}

}  // namespace

Rest step(const PowerWatchInput& in, const PowerWatchParams& params, PowerWatchState& state) {
  state.powered = state.powered || in.report.motorPower;
  const Rest cause = causeIn(in.report, state.powered);
  if (cause == Rest::none) {
    if (in.time.us >= state.until.us) state.rest = Rest::none;
    return state.rest;
  }
  const bool battery = cause == Rest::batteryLow;
  const double settles = battery ? params.batterySeconds : params.settleSeconds;
  state.rest = cause;
  state.until = {in.time.us + TimeUs::fromSeconds(settles).us};
  return state.rest;
}

}  // namespace kelpie::agent
