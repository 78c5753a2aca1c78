// SPDX-License-Identifier: Apache-2.0
#include "robot/agent/PowerWatch.h"

namespace kelpie::agent {
namespace {

Rest causeIn(const PowerReport& report) {
  if (report.paused) return Rest::paused;
  if (report.overCurrent) return Rest::overCurrent;
  if (report.hot) return Rest::hot;
  if (report.fanFault) return Rest::fan;
  return report.batteryLow ? Rest::batteryLow : Rest::none;
}

}  // namespace

Rest step(const PowerWatchInput& in, const PowerWatchParams& params, PowerWatchState& state) {
  const Rest cause = causeIn(in.report);
  if (cause == Rest::none) {
    if (in.time.us >= state.until.us) state.rest = Rest::none;
    return state.rest;
  }
  const bool pause = cause == Rest::paused;
  const double settles = pause ? params.settleSeconds : params.batterySeconds;
  state.rest = cause;
  state.until = {in.time.us + TimeUs::fromSeconds(settles).us};
  return state.rest;
}

}  // namespace kelpie::agent
