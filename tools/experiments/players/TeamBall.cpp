// SPDX-License-Identifier: Apache-2.0
// Four robots see one ball; in every second trial one of them is wrong about its own place. The
// fused ball beside that of the robot with the smallest covariance.
#include <cmath>

#include "tools/experiments/harness/Statistics.h"
#include "tools/experiments/harness/Trials.h"
#include "tools/experiments/players/Player.h"
#include "tools/sim/world/Ball.h"

namespace kelpie::experiments {
namespace {

constexpr std::size_t kPlayers = kTeammates + 1;
constexpr int kFrames = 240;
constexpr int kSettled = 120;
constexpr double kReach = 250.0;  // cm, to which the ball is seen
constexpr double kRecall = 0.95;
constexpr double kMaxAge = 1.5;  // s since the ball was seen

struct Tally {
  Values single, fused, singleSd, fusedSd;
  Values nees;     // of the fused ball
  Share outvoted;  // frames in which a robot's ball was
};

struct Team {
  std::vector<Player> players;
  sim::Ball ball;
  Radio radio;
  Random random;
  std::size_t wrong = kPlayers;  // who believes a wrong pose; kPlayers: nobody
};

Team teamOf(std::uint64_t seed, bool oneWrong) {
  Random random(seed);
  Team team{{}, {}, Radio(kPlayers, random.next()), Random(random.next())};
  team.ball.position = {random.uniform(80, 280), random.uniform(120, 420)};
  const double way = random.uniform(-maths::kPi, maths::kPi);
  const double speed = random.chance(0.5) ? random.uniform(10.0, 60.0) : 0.0;
  team.ball.velocity = {speed * maths::cos(way), speed * maths::sin(way)};
  if (oneWrong) team.wrong = random.index(kPlayers);
  for (std::size_t i = 0; i < kPlayers; ++i) {
    const Point2<Field> from{random.uniform(40, 320), random.uniform(60, 480)};
    const Angle to = bearing(robotFromField({from, {}}, team.ball.position));
    const Pose2 truth{from, to + Angle::deg(random.uniform(-30, 30))};
    Pose2 belief = truth;
    if (i == team.wrong) {
      belief = {{360.0 - from.x, 540.0 - from.y}, truth.heading + Angle::deg(180.0)};
    }
    team.players.emplace_back(truth, static_cast<std::uint8_t>(i + 1), random.next());
    team.players.back().believe(belief, 8.0, Angle::deg(4.0));
  }
  return team;
}

// Follows the ball, and looks round for landmarks a third of the time.
double panOf(const Player& player, Point2<Field> ball, int frame) {
  const int phase = frame % 60;
  if (phase >= 40) return 1.4 * maths::sin(2.0 * maths::kPi * (phase - 40) / 20.0);
  return player.bearingOf(ball).rad();
}

WorldModel stepPlayer(Team& team, std::size_t i, int frame) {
  Player& player = team.players[i];
  player.walk({4.0, 0.0, 0.0});
  player.turnHead(panOf(player, team.ball.position, frame + 13 * static_cast<int>(i)));
  if (i != team.wrong) player.seeLandmarks();
  const double range = distance(player.truth.pose().position, team.ball.position);
  const bool seen = player.inView(player.bearingOf(team.ball.position)) && range < kReach;
  if (seen && team.random.chance(kRecall)) player.lookAtBall(team.ball.position);
  player.input.team = team.radio.receive(i);
  const WorldModel world = player.step();
  team.radio.send(i, world.message);
  return world;
}

double sdOf(const std::array<double, 4>& covariance) {
  return std::sqrt(0.5 * (covariance[0] + covariance[3]));
}

// The team's ball is the one that the first player knows who is not wrong himself.
void compareBalls(const Team& team, const std::vector<WorldModel>& worlds, Tally& tally) {
  const BallEstimate* surest = nullptr;
  for (const WorldModel& world : worlds) {
    const BallEstimate& ball = world.ball;
    if (!ball.present || ball.secondsSinceSeen > kMaxAge) continue;
    if (surest == nullptr || sdOf(ball.fieldCovariance) < sdOf(surest->fieldCovariance))
      surest = &ball;
  }
  const TeamBall& fused = worlds[team.wrong == 0 ? 1 : 0].teamBall;
  if (surest == nullptr || !fused.present) return;
  const double error = distance(fused.position, team.ball.position);
  tally.single.push_back(distance(surest->position, team.ball.position));
  tally.fused.push_back(error);
  tally.singleSd.push_back(sdOf(surest->fieldCovariance));
  tally.fusedSd.push_back(sdOf(fused.covariance));
  tally.nees.push_back(maths::square(error / sdOf(fused.covariance)));
  tally.outvoted.count(fused.outvoted > 0);
}

void play(Team team, Tally& tally) {
  std::vector<WorldModel> worlds(kPlayers);
  for (int frame = 0; frame < kFrames; ++frame) {
    sim::roll(team.ball, kFrameSeconds, {});
    team.radio.pass();
    for (std::size_t i = 0; i < kPlayers; ++i) worlds[i] = stepPlayer(team, i, frame);
    if (frame >= kSettled) compareBalls(team, worlds, tally);
  }
}

void put(Json& json, const std::string& prefix, const Tally& tally) {
  json[prefix + "single_cm"] = mean(tally.single);
  json[prefix + "fused_cm"] = mean(tally.fused);
  json[prefix + "single_p95_cm"] = percentile(tally.single, 0.95);
  json[prefix + "fused_p95_cm"] = percentile(tally.fused, 0.95);
  json[prefix + "single_sd_cm"] = mean(tally.singleSd);
  json[prefix + "fused_sd_cm"] = mean(tally.fusedSd);
  json[prefix + "fused_rms_over_sd"] = std::sqrt(0.5 * mean(tally.nees));
  json[prefix + "outvoted_share"] = tally.outvoted.value();
}

Expected<Json> teamBall(const Request& request) {
  Tally right, wrong;
  Random seeds(request.seed);
  eachTrial(request, [&](const Trial& trial) {
    const bool oneWrong = trial.number % 2 == 1;
    play(teamOf(seeds.next(), oneWrong), oneWrong ? wrong : right);
  });
  Json json;
  put(json, "", right);
  put(json, "one_wrong_", wrong);
  return json;
}

const Registration kTeamBall("team-ball",
                             "four robots and one ball, at times a wrong pose: the fused ball",
                             {Option::trials, Option::seed}, 100, teamBall);

}  // namespace
}  // namespace kelpie::experiments
