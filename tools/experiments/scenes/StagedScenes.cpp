// SPDX-License-Identifier: Apache-2.0
#include "tools/experiments/scenes/StagedScenes.h"

#include "tools/session/SceneSession.h"
#include "tools/session/Teams.h"

namespace kelpie::experiments {
namespace {

Status stage(const Request& request, const StagedScenes& scenes, std::size_t kind,
             cli::SessionOptions& session) {
  const std::string a = sideOr(request.sideA, "kelpie");
  const std::string b = sideOr(request.sideB, scenes.opponents);
  return cli::useScene(scenes.kinds[kind], {0, 0, a, b}, session);
}

cli::SessionOptions sessionFor(const Request& request, const StagedScenes& scenes, int number) {
  const auto kinds = static_cast<int>(scenes.kinds.size());
  cli::SessionOptions session = sessionOf(request, trialOf(request, number / kinds));
  session.percepts = request.fast;
  session.keepFrames = true;
  session.set.insert(session.set.end(), scenes.set.begin(), scenes.set.end());
  cli::useRules("2005", session);
  const Status staged = stage(request, scenes, static_cast<std::size_t>(number % kinds), session);
  if (!staged) session.pycode = request.sideA;  // playScenes() has asked before
  return session;
}

}  // namespace

Status playScenes(const Request& request, const StagedScenes& scenes) {
  cli::SessionOptions first = sessionOf(request, trialOf(request, 0));
  const Status staged = stage(request, scenes, 0, first);
  if (!staged) return staged;
  const auto kinds = static_cast<int>(scenes.kinds.size());
  Matches matches;
  matches.count = kinds * request.trials;
  matches.session = [&](int number) { return sessionFor(request, scenes, number); };
  matches.judge = [&](int number, const cli::SessionResult&, const Played& played) {
    scenes.judge(static_cast<std::size_t>(number % kinds), played);
  };
  return playMatches(request, matches);
}

std::optional<double> goalAfter(const Played& played, TeamColour team) {
  if (played.moments.empty()) return std::nullopt;
  for (const sim::MatchEvent& event : played.events)
    if (event.kind == sim::EventKind::goal && event.team == team)
      return event.time.seconds() - played.moments.front().seconds();
  return std::nullopt;
}

}  // namespace kelpie::experiments
