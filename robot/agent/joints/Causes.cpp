// SPDX-License-Identifier: Apache-2.0
#include "robot/agent/joints/Causes.h"

namespace kelpie::agent {
namespace {

struct Kind {
  Cause cause;
  bool now = false;
  double seconds = 0.0;  // that it counts on
};

// The gravest first. Sony's PowerMonitor ends the system for the pause switch and the battery
// alone (openr-measured.md 5).
std::array<Kind, 7> kindsOf(const CausesIn& in, const CausesParams& params) {
  const PowerReport& report = in.report;
  const double battery = params.batterySeconds;
  return {{{{Rest::batteryLow, Demand::switchOff}, report.batteryLow, battery},
           {{Rest::overCurrent, Demand::noPower}, report.overCurrent, battery},
           {{Rest::hot, Demand::noPower}, report.hot, battery},
           {{Rest::fan, Demand::noPower}, report.fanFault, battery},
           {{Rest::jointStuck, Demand::noPower}, in.stuck, 0.0},
           {{Rest::paused, Demand::lie}, report.paused, params.settleSeconds},
           {{Rest::blind, Demand::lie}, in.blind, 0.0}}};
}

bool counts(const Kind& kind, TimeUs now, CausesState& state) {
  auto& until = state.until[static_cast<std::size_t>(kind.cause.rest)];
  if (kind.now) until = TimeUs{now.us + TimeUs::fromSeconds(kind.seconds).us};
  if (until && !kind.now && now.us >= until->us) until.reset();
  return until.has_value();
}

bool pauseIsHeld(const CausesIn& in, const CausesParams& params, CausesState& state) {
  if (!in.report.paused) state.pausedSince.reset();
  if (in.report.paused && !state.pausedSince) state.pausedSince = in.time;
  return state.pausedSince && (in.time - *state.pausedSince).seconds() >= params.pauseHoldSeconds;
}

}  // namespace

Cause step(const CausesIn& in, const CausesParams& params, CausesState& state) {
  Cause gravest;
  for (const Kind& kind : kindsOf(in, params)) {
    const bool counting = counts(kind, in.time, state);
    if (counting && gravest.rest == Rest::none) gravest = kind.cause;
  }
  if (pauseIsHeld(in, params, state)) return {Rest::paused, Demand::switchOff};
  return gravest;
}

}  // namespace kelpie::agent
