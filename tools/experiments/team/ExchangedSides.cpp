// SPDX-License-Identifier: Apache-2.0
#include "tools/experiments/team/ExchangedSides.h"

#include "tools/session/Teams.h"

namespace kelpie::experiments {
namespace {

constexpr double kMinutes = 5.0;

bool redIsA(int number) { return number % 2 == 0; }

cli::SessionOptions sessionFor(const Request& request, const char* opponents, int number) {
  const Trial trial = trialOf(request, number / 2);
  cli::SessionOptions session = sessionOf(request, trial);
  const std::string a = sideOr(request.sideA, "kelpie");
  const std::string b = sideOr(request.sideB, opponents);
  session.percepts = request.fast;
  session.keepFrames = true;
  session.seconds = 60.0 * (request.minutes > 0.0 ? request.minutes : kMinutes);
  cli::useRules("2005", session);
  const bool aIsRed = redIsA(number);
  const Status used = cli::useTeams({4, 4, aIsRed ? a : b, aIsRed ? b : a}, session);
  if (!used) session.pycode = a;  // what is wrong with it the session says itself
  return session;
}

}  // namespace

Status playExchanged(const Request& request, const char* opponents,
                     const std::function<void(bool aIsRed, const Played& played)>& judge) {
  Matches matches;
  matches.count = 2 * request.trials;
  matches.session = [&](int number) { return sessionFor(request, opponents, number); };
  matches.judge = [&](int number, const cli::SessionResult&, const Played& played) {
    judge(redIsA(number), played);
  };
  return playMatches(request, matches);
}

std::vector<bool> inPlay(const Played& played) {
  std::vector<bool> plays;
  std::size_t next = 0;
  bool now = false;
  for (const PlayedMoment& moment : played.moments) {
    for (; next < played.events.size() && played.events[next].time <= moment.truth.time; ++next) {
      const sim::EventKind kind = played.events[next].kind;
      if (kind == sim::EventKind::play) now = true;
      if (kind == sim::EventKind::goal || kind == sim::EventKind::half ||
          kind == sim::EventKind::end || kind == sim::EventKind::ready)
        now = false;
    }
    plays.push_back(now);
  }
  return plays;
}

}  // namespace kelpie::experiments
