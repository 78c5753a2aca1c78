// SPDX-License-Identifier: Apache-2.0
// The states of a match in their order: initial, ready, set, playing, and ready again after a goal;
// two halves of play, then finished. The half's clock runs while the ball is in play only, and is
// not stopped by balls out and penalties (rule book: it stops for kick-offs). Teams do not change
// ends: in our field red defends y = 0 in both halves; the kick-off of the second half is the other
// team's. The half-time break takes no time.
#pragma once

#include <optional>

#include "robot/body/Rules.h"
#include "tools/sim/rules/MatchScene.h"

namespace kelpie::sim {

struct ClockIn {
  TimeUs time;
  bool placesTaken = false;           // all have stood where they may for readyStill
  std::optional<TeamColour> goalFor;  // which team scored since the last step
};

struct ClockState {
  PlayState state = PlayState::initial;
  bool firstHalf = true;
  TeamColour firstKickOff = TeamColour::red;
  TeamColour kickOff = TeamColour::red;  // whose the last or the next one is
  TimeUs began;                          // the state
  TimeUs last;                           // step
  TimeUs played;                         // of the half

  double inState() const { return (last - began).seconds(); }
  // Of the half; in ready, of that state.
  double secondsLeft(const body::Rules& rules) const;
};

ClockState clockFor(TeamColour firstKickOff);
// In play, with the second half before it.
ClockState clockInPlay(TeamColour firstKickOff);

// What happened: a state that began, or a half that ended.
std::optional<EventKind> step(const ClockIn& in, const body::Rules& rules, ClockState& clock);

}  // namespace kelpie::sim
