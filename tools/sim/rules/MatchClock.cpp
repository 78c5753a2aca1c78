// SPDX-License-Identifier: Apache-2.0
#include "tools/sim/rules/MatchClock.h"

#include <algorithm>

namespace kelpie::sim {
namespace {

std::optional<EventKind> enter(PlayState state, EventKind kind, ClockState& clock) {
  clock.state = state;
  clock.began = clock.last;
  return kind;
}

std::optional<EventKind> endHalf(ClockState& clock) {
  if (!clock.firstHalf) return enter(PlayState::finished, EventKind::end, clock);
  clock.firstHalf = false;
  clock.played = {};
  clock.kickOff = otherTeam(clock.firstKickOff);
  return enter(PlayState::initial, EventKind::half, clock);
}

std::optional<EventKind> play(const ClockIn& in, TimeUs gone, const body::Rules& rules,
                              ClockState& clock) {
  clock.played = clock.played + gone;
  const bool over = clock.played.seconds() >= rules.halfTime;
  if (in.goalFor) {
    clock.kickOff = otherTeam(*in.goalFor);
    // A goal of the half's last tick has no kick-off any more.
    if (!over) return enter(PlayState::ready, EventKind::ready, clock);
  }
  if (over) return endHalf(clock);
  return std::nullopt;
}

}  // namespace

double ClockState::secondsLeft(const body::Rules& rules) const {
  if (state == PlayState::finished) return 0.0;
  const double left =
      state == PlayState::ready ? rules.readyTime - inState() : rules.halfTime - played.seconds();
  return std::max(0.0, left);
}

ClockState clockFor(TeamColour firstKickOff) {
  ClockState clock;
  clock.firstKickOff = firstKickOff;
  clock.kickOff = firstKickOff;
  return clock;
}

ClockState clockInPlay(TeamColour firstKickOff) {
  ClockState clock = clockFor(firstKickOff);
  clock.firstHalf = false;
  clock.state = PlayState::playing;
  return clock;
}

std::optional<EventKind> step(const ClockIn& in, const body::Rules& rules, ClockState& clock) {
  const TimeUs gone = in.time - clock.last;
  clock.last = in.time;
  switch (clock.state) {
    case PlayState::initial:
      if (clock.inState() < rules.initialTime) return std::nullopt;
      return enter(PlayState::ready, EventKind::ready, clock);
    case PlayState::ready:
      if (!in.placesTaken && clock.inState() < rules.readyTime) return std::nullopt;
      return enter(PlayState::set, EventKind::set, clock);
    case PlayState::set:
      if (clock.inState() < rules.setTime) return std::nullopt;
      return enter(PlayState::playing, EventKind::play, clock);
    case PlayState::playing: return play(in, gone, rules, clock);
    case PlayState::finished: break;
  }
  return std::nullopt;
}

}  // namespace kelpie::sim
