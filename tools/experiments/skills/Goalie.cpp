// SPDX-License-Identifier: Apache-2.0
// How much a goalie helps (checklist A-4.3.1.0): the same attacker from the same starts against the
// goalie of 2006, that of 2004 and an empty goal. Every try begins with the scenario attack of its
// seed and ends with a goal or after 60 s.
#include <array>
#include <cmath>

#include "tools/experiments/skills/Judges.h"
#include "tools/experiments/skills/Tries.h"

namespace kelpie::experiments {
namespace {

constexpr double kLimit = 60.0;  // simulated seconds

// Ways by number.
enum : std::size_t { kEmpty, k2006, k2004, kVariants };

struct Found {
  bool scored = false;
  double seconds = kLimit;
  int ownGoals = 0;  // of the attacker
  Kept kept;
};

Found foundIn(const cli::SessionResult& result, const Played& played, bool keeper) {
  Found found;
  found.scored = !result.goals.empty() && result.goals[0] <= kLimit;
  if (found.scored) found.seconds = result.goals[0];
  found.ownGoals = static_cast<int>(result.ownGoals.size());
  if (keeper) found.kept = keptIn(played, found.scored);
  return found;
}

Json figuresOf(const Request& request, const std::vector<Found>& all) {
  Json goals = Json::array();
  Json keeperOwn = Json::array();
  Share scored;
  Values seconds;
  int ownGoals = 0;
  int keeperOwnGoals = 0;
  Share outside;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const Found& found = all[i];
    if (found.scored) goals.push_back(request.seed + i);
    if (found.kept.setOff) keeperOwn.push_back(request.seed + i);
    scored.count(found.scored);
    seconds.push_back(found.seconds);
    ownGoals += found.ownGoals;
    keeperOwnGoals += found.kept.setOff ? 1 : 0;
    outside.add(found.kept.outside);
  }
  return Json{{"goals_rate", scored.value()},
              {"median_s", percentile(seconds, 0.5)},
              {"own_goals", ownGoals},
              {"goalie_own_goals", keeperOwnGoals},
              {"goalie_outside_box", outside.value()},
              {"seeds_with_goal", goals},
              {"seeds_with_goalie_own_goal", keeperOwn}};
}

Expected<Json> goalie(const Request& request) {
  std::array<std::vector<Found>, kVariants> found;
  for (auto& all : found) all.resize(static_cast<std::size_t>(request.trials));
  Tries tries;
  tries.ways = {{"empty", {}}, {"goalie", {}}, {"goalie_2004", {}}};
  tries.each = request.trials;
  tries.setUp = [](const Try& one, cli::SessionOptions& session) {
    session.scenario = "attack";
    session.seconds = kLimit;
    if (one.way == k2006) addKeeper(PlayerKind::goalie, session);
    if (one.way == k2004) addKeeper(PlayerKind::goalie2004, session);
  };
  tries.judge = [&](const Try& one, const cli::SessionResult& result, const Played& played) {
    found[one.way][static_cast<std::size_t>(one.trial.number)] =
        foundIn(result, played, one.way != kEmpty);
  };
  const Status played = playTries(request, tries);
  if (!played) return Error{played.error()};
  const Json empty = figuresOf(request, found[kEmpty]);
  const Json of2006 = figuresOf(request, found[k2006]);
  const Json of2004 = figuresOf(request, found[k2004]);
  const double emptyRate = empty["goals_rate"];
  return Json{{"ratio_to_empty", ratio(of2006["goals_rate"], emptyRate)},
              {"ratio_2004_to_empty", ratio(of2004["goals_rate"], emptyRate)},
              {"own_goals", empty["own_goals"].get<int>() + of2006["own_goals"].get<int>() +
                                of2004["own_goals"].get<int>()},
              {"goalie_own_goals", of2006["goalie_own_goals"]},
              {"goalie_outside_box", of2006["goalie_outside_box"]},
              {"empty", empty},
              {"goalie", of2006},
              {"goalie_2004", of2004}};
}

const Registration kGoalie(
    "goalie", "an attacker against the goalie of 2006, of 2004 and none: goals in 60 s",
    {Option::trials, Option::seed, Option::randomised, Option::params, Option::fast}, 50, goalie);

}  // namespace
}  // namespace kelpie::experiments
