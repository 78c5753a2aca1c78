// SPDX-License-Identifier: Apache-2.0
// How two teams run with the ball and whether their forwards stand, by true places alone: matches
// (--fast: of percepts, else from images on physical bodies) by the rules of 2005 in which the
// teams change colours. A run is the time in which one forward is the nearest of all to the ball
// and near it. It cannot tell a ball that is pushed from one that is carried between the paws; the
// distance to it says so.
#include <algorithm>
#include <array>

#include "tools/experiments/harness/Statistics.h"
#include "tools/experiments/team/ExchangedSides.h"

namespace kelpie::experiments {
namespace {

constexpr double kWith = 45.0;     // cm from the neck base to a ball that it runs with
constexpr double kBreak = 0.5;     // s without, after which the run is over
constexpr double kRun = 100.0;     // cm towards the goal that make a run
constexpr double kStill = 5.0;     // cm within
constexpr double kStillFor = 5.0;  // s: so who stands
constexpr std::size_t kImages = 30;

struct Run {
  TeamColour team = TeamColour::red;
  std::uint8_t player = 0;  // 0: nobody has it
  double begin = 0.0, end = 0.0;
  Point2<Field> from, to;
  Values ahead;  // cm to the ball, of each image
};

// Of one team.
struct Found {
  int goals = 0;
  Share still;
  Values gains, speeds, ahead;

  void add(const Run& run) {
    const double gain = (run.team == TeamColour::red ? 1.0 : -1.0) * (run.to.y - run.from.y);
    if (run.player < 2 || gain < kRun) return;
    gains.push_back(gain);
    speeds.push_back(gain / (run.end - run.begin));
    ahead.insert(ahead.end(), run.ahead.begin(), run.ahead.end());
  }
};
using Teams = std::array<Found, 2>;  // by colour

void judgeRuns(const Played& played, const std::vector<bool>& plays, Teams& teams) {
  Run run;
  const auto end = [&] {
    teams[static_cast<std::size_t>(run.team)].add(run);
    run = {};
  };
  Point2<Field> last;
  for (std::size_t i = 0; i < played.moments.size(); ++i) {
    const sim::TruthFrame& truth = played.moments[i].truth;
    const double now = truth.time.seconds();
    const bool put = distance(last, truth.ball) > 20.0;  // faster than any ball: by hand
    last = truth.ball;
    if (!plays[i] || put || now - run.end > kBreak) end();
    if (!plays[i] || put) continue;
    const sim::RobotTruth& one = nearestToBall(truth);
    const double away = distance(one.pose.position, truth.ball);
    if (away > kWith) continue;
    if (one.team != run.team || one.player != run.player) {
      end();
      run = {one.team, one.player, now, now, truth.ball, truth.ball, {}};
    }
    run.end = now;
    run.to = truth.ball;
    run.ahead.push_back(away);
  }
  end();
}

bool onField(const body::FieldDescription& field, Point2<Field> p) {
  return p.x > 0.0 && p.x < field.width && p.y > 0.0 && p.y < field.length;
}

// Each second the five before it, of who was on the field and in play in all of them.
void judgeStanding(const Played& played, const std::vector<bool>& plays,
                   const body::FieldDescription& field, Teams& teams) {
  const auto window = static_cast<std::size_t>(kStillFor * kImages);
  for (std::size_t i = window; i < played.moments.size(); i += kImages)
    for (std::size_t robot = 0; robot < played.moments[i].truth.robots.size(); ++robot) {
      const sim::RobotTruth& one = played.moments[i].truth.robots[robot];
      bool counts = one.player > 1, still = true;
      for (std::size_t j = i - window; j < i && counts; ++j) {
        const Point2<Field> place = played.moments[j].truth.robots[robot].pose.position;
        counts = plays[j] && onField(field, place);
        still = still && distance(place, one.pose.position) < kStill;
      }
      if (counts) teams[static_cast<std::size_t>(one.team)].still.count(still);
    }
}

void judgeGoals(const Played& played, Teams& teams) {
  for (const sim::MatchEvent& event : played.events)
    if (event.kind == sim::EventKind::goal) ++teams[static_cast<std::size_t>(event.team)].goals;
}

void join(const Found& found, Found& all) {
  all.goals += found.goals;
  all.still.add(found.still);
  all.gains.insert(all.gains.end(), found.gains.begin(), found.gains.end());
  all.speeds.insert(all.speeds.end(), found.speeds.begin(), found.speeds.end());
  all.ahead.insert(all.ahead.end(), found.ahead.begin(), found.ahead.end());
}

Json figuresOf(const Found& found, int matches) {
  return Json{{"goals_per_match", ratio(found.goals, matches)},
              {"forwards_still_share", found.still.value()},
              {"runs_per_match", ratio(static_cast<double>(found.gains.size()), matches)},
              {"run_median_cm", percentile(found.gains, 0.5)},
              {"run_longest_cm", percentile(found.gains, 1.0)},
              {"run_speed_median_cm_s", percentile(found.speeds, 0.5)},
              {"ball_ahead_p10_cm", percentile(found.ahead, 0.1)},
              {"ball_ahead_median_cm", percentile(found.ahead, 0.5)},
              {"ball_ahead_p90_cm", percentile(found.ahead, 0.9)}};
}

Expected<Json> runs(const Request& request) {
  const auto field = body::fieldDescription(request.field.empty() ? "2006" : request.field);
  if (!field) return Error{field.error()};
  Teams sides;  // a, b
  const Status done = playExchanged(request, "runner", [&](bool aIsRed, const Played& played) {
    Teams teams;
    const std::vector<bool> plays = inPlay(played);
    judgeRuns(played, plays, teams);
    judgeStanding(played, plays, *field, teams);
    judgeGoals(played, teams);
    join(teams[aIsRed ? 0 : 1], sides[0]);
    join(teams[aIsRed ? 1 : 0], sides[1]);
  });
  if (!done) return Error{done.error()};
  return Json{{"matches", 2 * request.trials},
              {"a", figuresOf(sides[0], 2 * request.trials)},
              {"b", figuresOf(sides[1], 2 * request.trials)}};
}

const Registration kRuns("runs",
                         "how two teams run with the ball (--b: teams/runner), and who stands",
                         {Option::trials, Option::seed, Option::field, Option::fast,
                          Option::minutes, Option::side, Option::opponents},
                         2, runs);

}  // namespace
}  // namespace kelpie::experiments
