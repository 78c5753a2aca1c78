// SPDX-License-Identifier: Apache-2.0
#include "tools/match/EventWords.h"

#include <fmt/core.h>

namespace kelpie::match {
namespace {

const char* nameOf(TeamColour team) { return team == TeamColour::red ? "red" : "blue"; }

std::string robotOf(const sim::MatchEvent& event) {
  return fmt::format("{} {}", nameOf(event.team), event.player);
}

std::string goalWords(const sim::MatchEvent& event) {
  if (event.reason.view() == "own goal") return fmt::format("Own goal for {}", nameOf(event.team));
  const std::string by = event.player > 0 ? " by player " + std::to_string(event.player) : "";
  return fmt::format("Goal of {}{}", nameOf(event.team), by);
}

std::string outWords(const sim::MatchEvent& event) {
  return "The ball is out" + (event.player > 0 ? ", touched last by " + robotOf(event) : "");
}

std::string whatOf(const sim::MatchEvent& event) {
  using sim::EventKind;
  switch (event.kind) {
    case EventKind::start: return "The match begins";
    case EventKind::goal: return goalWords(event);
    case EventKind::out: return outWords(event);
    case EventKind::end: return "The match is over";
    case EventKind::ready: return fmt::format("Ready for the kick-off of {}", nameOf(event.team));
    case EventKind::set: return "Set: all stand where they may";
    case EventKind::play: return "Play";
    case EventKind::half: return "The first half is over";
    case EventKind::penalty: return robotOf(event) + " is taken off";
    case EventKind::back: return robotOf(event) + " comes back";
    case EventKind::stuck: return "The ball is put elsewhere";
    case EventKind::placed: return robotOf(event) + " is put where it may stand";
    case EventKind::taken: return "Somebody takes the ball away";
    case EventKind::returned: return "The ball is back";
    case EventKind::carried: return robotOf(event) + " is carried elsewhere";
  }
  return "An unknown event";
}

}  // namespace

std::string sentenceOf(const sim::MatchEvent& event) {
  const std::string what = whatOf(event);
  const bool said = event.reason.view().empty() || event.reason.view() == "own goal";
  return what + (said ? "." : fmt::format(": {}.", event.reason.view()));
}

}  // namespace kelpie::match
