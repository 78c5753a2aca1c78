// SPDX-License-Identifier: Apache-2.0
// Two teams in the same situations (tools/sim/staging/Scenes.h), kind by kind: each scene is played
// twice with colours exchanged, so that what a situation gives to either side falls out. Percepts
// in place of images; on other bodies `kelpie farm play --scenes` plays the same.
#include "tools/experiments/harness/ChildProcesses.h"
#include "tools/experiments/harness/Statistics.h"
#include "tools/experiments/match/Matches.h"
#include "tools/league/PairedStatistics.h"
#include "tools/league/value/MatchValue.h"
#include "tools/session/SceneSession.h"
#include "tools/session/Session.h"
#include "tools/sim/staging/Scenes.h"

namespace kelpie::experiments {
namespace {

// What A has of the two matches of a scene.
struct Pair {
  double goalsFor = 0.0;
  double goalsAgainst = 0.0;
  double value = 0.0;  // expected goals for less against (tools/league/value)

  template <int = 0>
  static constexpr auto fields() {
    return fieldList(field("goalsFor", &Pair::goalsFor), field("goalsAgainst", &Pair::goalsAgainst),
                     field("value", &Pair::value));
  }
};

// Of one seed, a pair for each kind.
struct PlayedScenes {
  std::vector<Pair> pairs;

  template <int = 0>
  static constexpr auto fields() {
    return fieldList(field("pairs", &PlayedScenes::pairs));
  }
};

// What every scene is played and judged by.
struct Sides {
  std::string a, b;
  value::Models models;
};

Status playOnce(const Sides& sides, const std::string& kind, std::uint64_t seed, bool aIsRed,
                Pair& pair) {
  cli::SessionOptions session;
  session.seed = seed;
  session.physical = false;
  session.percepts = true;
  session.set = {cli::kNoReload};
  const cli::TeamPlan plan{0, 0, aIsRed ? sides.a : sides.b, aIsRed ? sides.b : sides.a};
  const Status used = cli::useScene(kind, plan, session);
  if (!used) return used;
  Status valued = Done{};
  cli::SessionTalk talk;
  talk.line = [](const std::string&) {};
  talk.frames = [&](const std::string&, const std::string& worldLog) {
    const auto field = *body::fieldDescription(session.field);
    const auto figures = value::figuresOfLog(worldLog, sides.models, field);
    if (!figures) {
      valued = Error{figures.error()};
      return;
    }
    const double reds = value::sceneValue(*figures, sides.models.far.horizon, session.seconds);
    pair.value += aIsRed ? reds : -reds;
  };
  session.keepTruth = true;
  const cli::SessionResult result = cli::runSession(session, talk);
  if (!result.trouble.empty()) return Error{"scene " + kind + ": " + result.trouble};
  if (!valued) return valued;
  const bool own = (session.team == "red") == aIsRed;
  pair.goalsFor += static_cast<double>((own ? result.goals : result.ownGoals).size());
  pair.goalsAgainst += static_cast<double>((own ? result.ownGoals : result.goals).size());
  return Done{};
}

Expected<PlayedScenes> playSeed(const Sides& sides, const Trial& trial) {
  PlayedScenes played;
  for (const std::string& kind : sim::sceneKinds()) {
    Pair pair;
    for (const bool aIsRed : {true, false}) {
      const Status done = playOnce(sides, kind, trial.seed, aIsRed, pair);
      if (!done) return Error{done.error()};
    }
    played.pairs.push_back(pair);
  }
  return played;
}

// Of a scene, which is half of a pair.
Json figuresOf(const std::vector<Pair>& pairs) {
  Values scored, conceded;
  league::Differences differences, values;
  for (const Pair& pair : pairs) {
    scored.push_back(0.5 * pair.goalsFor);
    conceded.push_back(0.5 * pair.goalsAgainst);
    differences.push_back(0.5 * (pair.goalsFor - pair.goalsAgainst));
    values.push_back(0.5 * pair.value);
  }
  const league::Interval interval = league::bootstrap(differences, {});
  const league::Interval worth = league::bootstrap(values, {});
  return {{"goals_for", mean(scored)},
          {"goals_against", mean(conceded)},
          {"goals_difference", mean(differences)},
          {"goals_difference_low", interval.low},
          {"goals_difference_high", interval.high},
          {"value", mean(values)},
          {"value_low", worth.low},
          {"value_high", worth.high},
          {"value_sd", league::spreadOf(values)}};
}

Expected<Json> sceneSides(const Request& request) {
  const auto models = value::readModels(value::modelFolder());
  if (!models) return Error{models.error()};
  const Sides sides{sideOr(request.sideA, "kelpie"), sideOr(request.sideB, "thesis"), *models};
  const auto seeds =
      trialsInChildProcesses(request, [&](const Trial& trial) { return playSeed(sides, trial); });
  if (!seeds) return Error{seeds.error()};
  const auto& kinds = sim::sceneKinds();
  std::vector<Pair> all;
  Json figures = Json::object(), each = Json::object();
  for (std::size_t kind = 0; kind < kinds.size(); ++kind) {
    std::vector<Pair> pairs;
    for (const PlayedScenes& played : *seeds) pairs.push_back(played.pairs[kind]);
    each[kinds[kind]] = figuresOf(pairs);
    all.insert(all.end(), pairs.begin(), pairs.end());
  }
  figures = figuresOf(all);
  figures["scenes"] = static_cast<double>(2 * all.size());
  figures["kinds"] = each;
  return figures;
}

const Registration kSceneSides("scenes",
                               "two teams (--a, --b) in the same drawn situations, kind by kind",
                               {Option::trials, Option::seed, Option::side, Option::opponents}, 20,
                               sceneSides);

}  // namespace
}  // namespace kelpie::experiments
