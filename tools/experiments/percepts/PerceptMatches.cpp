// SPDX-License-Identifier: Apache-2.0
// Whether a match of percepts (tools/percepts) is played as a match from images is, on the same
// kinematic bodies and by the same seeds: goals, kicks, holds, what the referee calls, and what
// robots believe. Both are judged by the true places and by what the agents knew.
#include <algorithm>
#include <chrono>
#include <map>
#include <string>

#include "tools/experiments/harness/Statistics.h"
#include "tools/experiments/match/Played.h"
#include "tools/experiments/team/TeamMatch.h"
#include "tools/sim/bodies/HoldWatch.h"
#include "tools/sim/rules/MatchScene.h"

namespace kelpie::experiments {
namespace {

constexpr double kSeconds = 600.0;      // of play
constexpr double kKickSpeed = 60.0;     // cm/s, which walking into a ball does not give
constexpr double kReach = 40.0;         // cm from the neck base to a ball that is kicked
constexpr double kKickAfterHold = 0.4;  // s: what rolls so soon was kicked out of a hold
constexpr double kWayTime = 2.0;        // s after a kick, in which its way is taken
constexpr double kBlowTime = 0.3;       // s, one blow and not each of its bounces
constexpr std::size_t kSampled = 10;    // frames between two in which beliefs are judged

struct Found {
  Values goals, outs;   // of each match
  Values speeds, wins;  // of each kick: cm/s, and cm nearer to the goal attacked, in 2 s
  Values holds;         // s, of each
  int lost = 0;         // holds that no kick ended
  std::map<std::string, int> calls;
  Share seen;                                    // frames in which the ball was seen
  Values poseErrors, ballErrors, headingErrors;  // cm, cm, deg
  double played = 0.0;                           // s, simulated
  double took = 0.0;                             // s, by the wall's clock
};

struct Kick {
  double seconds = 0.0;
  TeamColour team = TeamColour::red;
};

// Whoever is nearest to the ball has kicked it.
std::vector<Kick> judgeKicks(const TeamMatch& match, Found& found) {
  std::vector<Kick> kicks;
  for (std::size_t i = 1; i < match.truth.size(); ++i) {
    const sim::TruthFrame& truth = match.truth[i];
    const double speed = truth.ballVelocity.norm();
    const bool begins = speed >= kKickSpeed && match.truth[i - 1].ballVelocity.norm() < kKickSpeed;
    const sim::RobotTruth& kicker = nearestToBall(truth);
    if (!begins || distance(kicker.pose.position, truth.ball) > kReach) continue;
    if (!kicks.empty() && truth.time.seconds() - kicks.back().seconds < kBlowTime) continue;
    const double up = kicker.team == TeamColour::red ? 1.0 : -1.0;
    const sim::TruthFrame& later = match.at(truth.time.seconds() + kWayTime);
    found.speeds.push_back(speed);
    found.wins.push_back(up * (later.ball.y - truth.ball.y));
    kicks.push_back({truth.time.seconds(), kicker.team});
  }
  return kicks;
}

void judgeHolds(const TeamMatch& match, const std::vector<Kick>& kicks, Found& found) {
  for (std::size_t robot = 0; robot < match.truth[0].robots.size(); ++robot) {
    sim::HoldWatch watch;
    for (const sim::TruthFrame& truth : match.truth)
      watch.see(truth.time.seconds(), truth.robots[robot].pose, truth.ball);
    watch.finish();
    for (const sim::Hold& hold : watch.ended()) {
      found.holds.push_back(hold.seconds());
      const bool kicked = std::any_of(kicks.begin(), kicks.end(), [&](const Kick& kick) {
        return kick.seconds > hold.begin && kick.seconds < hold.end + kKickAfterHold;
      });
      found.lost += kicked ? 0 : 1;
    }
  }
}

void judgeCalls(const TeamMatch& match, Found& found) {
  for (const sim::MatchEvent& event : match.events)
    if (event.kind == sim::EventKind::penalty || event.kind == sim::EventKind::stuck)
      ++found.calls[std::string(event.reason.view())];
}

// Beliefs are of the own team's field, which is blue's turned.
void judgeBeliefs(const TeamMatch& match, Found& found) {
  const body::FieldDescription field = *body::fieldDescription("2006");
  for (const TeamRobot& robot : match.robots)
    for (std::size_t i = 0; i < robot.frames.size(); i += kSampled) {
      const TeamFrame& frame = robot.frames[i];
      if (!frame.plays()) continue;
      const sim::TruthFrame& truth = match.at(frame.seconds + 0.5 / 30.0);
      const auto self = std::find_if(truth.robots.begin(), truth.robots.end(),
                                     [&](const sim::RobotTruth& r) { return robot.is(r); });
      if (self == truth.robots.end()) continue;
      const Pose2 own = sim::ownView(field, robot.team, self->pose);
      const Point2<Field> ball = sim::ownView(field, robot.team, truth.ball);
      found.seen.count(frame.seen.present);
      found.poseErrors.push_back(distance(frame.pose.position, own.position));
      found.headingErrors.push_back((frame.pose.heading - own.heading).abs().deg());
      if (frame.ball) found.ballErrors.push_back(distance(frame.ballAt, ball));
    }
}

Json figuresOf(const Found& found) {
  const double tens = found.played / 600.0;
  Json calls = Json::object();
  for (const auto& [reason, number] : found.calls) calls[reason] = ratio(number, tens);
  const auto rate = [tens](const Values& values) {
    return ratio(static_cast<double>(values.size()), tens);
  };
  return Json{{"goals_per_match", mean(found.goals)},
              {"goals_sd", standardDeviation(found.goals)},
              {"outs_per_match", mean(found.outs)},
              {"kicks_per_10_min", rate(found.speeds)},
              {"kick_speed_cm_s", mean(found.speeds)},
              {"kick_way_cm", mean(found.wins)},
              {"kicks_backwards_share", shareUpTo(found.wins, -20.0)},
              {"holds_per_10_min", rate(found.holds)},
              {"hold_s", mean(found.holds)},
              {"held_balls_lost_share", ratio(found.lost, static_cast<double>(found.holds.size()))},
              {"calls_per_10_min", calls},
              {"ball_seen_share", found.seen.value()},
              {"pose_error_cm", mean(found.poseErrors)},
              {"pose_error_p90_cm", percentile(found.poseErrors, 0.9)},
              {"heading_error_deg", mean(found.headingErrors)},
              {"ball_error_median_cm", percentile(found.ballErrors, 0.5)},
              {"simulated_per_second", ratio(found.played, found.took)}};
}

Expected<Json> perceptMatches(const Request& request) {
  const double seconds = request.minutes > 0.0 ? 60.0 * request.minutes : kSeconds;
  Json figures = Json::object();
  for (const bool percepts : {true, false}) {
    Found found;
    TeamMatches matches;
    matches.count = request.trials;
    std::chrono::steady_clock::time_point began;
    matches.session = [&](int number) {
      cli::SessionOptions session = *teamSession(request, trialOf(request, number), "4v4", seconds);
      session.physical = false;
      session.percepts = percepts;
      began = std::chrono::steady_clock::now();
      return session;
    };
    matches.judge = [&](int, const cli::SessionResult& result, const TeamMatch& match) {
      found.took += std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
      found.played += result.seconds;
      found.goals.push_back(static_cast<double>(result.goals.size() + result.ownGoals.size()));
      found.outs.push_back(result.outs);
      judgeHolds(match, judgeKicks(match, found), found);
      judgeCalls(match, found);
      judgeBeliefs(match, found);
    };
    const Status played = playTeams(request, matches);
    if (!played) return Error{played.error()};
    figures[percepts ? "percepts" : "images"] = figuresOf(found);
  }
  return figures;
}

const Registration kPerceptMatches(
    "percept-matches", "whether matches of percepts are played as matches from images are",
    {Option::trials, Option::seed, Option::params, Option::minutes}, 10, perceptMatches);

}  // namespace
}  // namespace kelpie::experiments
