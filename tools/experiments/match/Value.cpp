// SPDX-License-Identifier: Apache-2.0
// What the value of play (tools/league/value) is worth on matches that it has not seen: log loss,
// calibration, how much a minute of it varies, and how it goes with goals. Matches of percepts
// between teams/kelpie and teams/thesis, every pairing in both colours in turn; the seeds of those
// that it was learnt from begin at 100000.
#include "tools/experiments/harness/Statistics.h"
#include "tools/experiments/team/TeamMatch.h"
#include "tools/league/value/Judged.h"
#include "tools/league/value/MatchValue.h"

namespace kelpie::experiments {
namespace {

constexpr double kSeconds = 300.0;  // of play
constexpr double kApart = 0.5;      // s between moments that are judged
constexpr std::size_t kBins = 10;
constexpr double kWholeMinute = 59.0;  // s; a minute of a team that is shorter is left out

constexpr TeamColour kColours[] = {TeamColour::red, TeamColour::blue};

// Which of the two teams plays in each colour; two pairings of four are of both teams.
struct Pairing {
  const char* red;
  const char* blue;
  bool mixed() const { return std::string(red) != blue; }
};
Pairing pairingOf(int number) {
  constexpr Pairing kPairings[] = {
      {"kelpie", "thesis"}, {"thesis", "kelpie"}, {"kelpie", "kelpie"}, {"thesis", "thesis"}};
  return kPairings[number % 4];
}

struct Found {
  std::vector<value::Said> near, far;
  Values minutes, minuteGoals;  // of a team and a minute
  Values matches, matchGoals;   // of a team and a match
  Values ahead, goalsAhead;     // kelpie's less thesis', of a match of both
  Values shots, shotGoals;      // of a team and a match: how many, and what they were worth
  double played = 0.0;          // s
};

void judgeTeam(const value::TeamFigures& team, double played, Found& found) {
  const auto whole = static_cast<std::size_t>((played + 60.0 - kWholeMinute) / 60.0);
  for (std::size_t i = 0; i < whole; ++i) {
    const bool any = i < team.minutes.size();
    found.minutes.push_back(any ? team.minutes[i].value : 0.0);
    found.minuteGoals.push_back(any ? team.minutes[i].goals : 0);
  }
  found.matches.push_back(team.value);
  found.matchGoals.push_back(team.goals);
  found.shots.push_back(team.shots);
  found.shotGoals.push_back(team.shotGoals);
}

void judge(const value::PlayedTruth& match, const value::Models& models, const Pairing& pairing,
           Found& found) {
  const body::FieldDescription field = *body::fieldDescription("2006");
  const std::vector<value::Row> rows = value::rowsOf(match, field, kApart);
  for (const value::Said& said : value::saidOf(rows, models.near)) found.near.push_back(said);
  for (const value::Said& said : value::saidOf(rows, models.far)) found.far.push_back(said);
  const value::MatchFigures figures = value::figuresOf(match, models, field);
  for (const TeamColour colour : kColours) judgeTeam(figures.of(colour), figures.played, found);
  found.played += figures.played;
  if (!pairing.mixed()) return;
  const double sign = std::string(pairing.red) == "kelpie" ? 1.0 : -1.0;
  found.ahead.push_back(sign * figures.value());
  found.goalsAhead.push_back(
      sign * (figures.of(TeamColour::red).goals - figures.of(TeamColour::blue).goals));
}

double relativeDeviation(const Values& values) {
  return ratio(standardDeviation(values), mean(values));
}

Json figuresOf(const std::vector<value::Said>& said) {
  const std::vector<value::Bin> bins = value::binsOf(said, kBins);
  const double loss = value::logLoss(said), base = value::baseLogLoss(said);
  Json calibration = Json::array();
  for (const value::Bin& bin : bins) calibration.push_back({{"said", bin.said}, {"was", bin.was}});
  return Json{{"scored_share", value::sharedBy(said)},
              {"log_loss", loss},
              {"base_log_loss", base},
              // Where nobody scored there is nothing to be better than.
              {"gain_rate", value::sharedBy(said) > 0.0 ? 1.0 - ratio(loss, base) : 0.0},
              {"calibration_error", value::calibrationError(bins)},
              {"calibration", calibration}};
}

Json figuresOf(const Found& found) {
  const double minutes = found.played / 60.0;
  return Json{{"near", figuresOf(found.near)},
              {"far", figuresOf(found.far)},
              {"played_min", minutes},
              {"goals", sum(found.matchGoals)},
              {"expected_goals", sum(found.matches)},
              {"minute_deviation_rate", relativeDeviation(found.minutes)},
              {"minute_goals_deviation_rate", relativeDeviation(found.minuteGoals)},
              {"minute_correlation", value::correlation(found.minutes, found.minuteGoals)},
              {"match_deviation_rate", relativeDeviation(found.matches)},
              {"match_goals_deviation_rate", relativeDeviation(found.matchGoals)},
              {"match_correlation", value::correlation(found.matches, found.matchGoals)},
              {"shots_per_10_min", ratio(sum(found.shots), minutes / 10.0)},
              {"shot_goals_per_10_min", ratio(sum(found.shotGoals), minutes / 10.0)},
              {"ahead", mean(found.ahead)},
              {"ahead_deviation", standardDeviation(found.ahead)},
              {"goals_ahead", mean(found.goalsAhead)},
              {"goals_ahead_deviation", standardDeviation(found.goalsAhead)}};
}

cli::SessionOptions pairedSession(const Request& request, const Trial& trial, const Pairing& pair,
                                  double seconds) {
  cli::TeamPlan plan = *cli::teamPlan("4v4");
  plan.redFolder = sideOr("", pair.red);
  plan.blueFolder = sideOr("", pair.blue);
  cli::SessionOptions session = sessionOf(request, trial);
  session.seconds = seconds;
  session.percepts = session.keepFrames = true;
  session.keepAll = false;
  const Status used = cli::useTeams(plan, session);
  (void)used;  // both folders are of the source tree
  return session;
}

Expected<Json> valueOfPlay(const Request& request) {
  const auto models = value::readModels(value::modelFolder());
  if (!models) return Error{models.error()};
  const double seconds = request.minutes > 0.0 ? 60.0 * request.minutes : kSeconds;
  Found found;
  TeamMatches matches;
  matches.count = request.trials;
  matches.session = [&](int number) {
    return pairedSession(request, trialOf(request, number), pairingOf(number), seconds);
  };
  matches.judge = [&](int number, const cli::SessionResult&, const TeamMatch& match) {
    judge({match.truth, match.events}, *models, pairingOf(number), found);
  };
  const Status played = playTeams(request, matches);
  if (!played) return Error{played.error()};
  return figuresOf(found);
}

const Registration kValue("value", "what the value of play says of matches that it has not seen",
                          {Option::trials, Option::seed, Option::params, Option::fast,
                           Option::minutes},
                          40, valueOfPlay);

}  // namespace
}  // namespace kelpie::experiments
