// SPDX-License-Identifier: Apache-2.0
#include "tools/sim/rules/Pushing.h"

#include "tools/sim/rules/KickOff.h"

namespace kelpie::sim {
namespace {

constexpr double kLook = 0.5;  // s between looks
// Stripes touch at 14 cm; a head reaches 3 cm farther than its stripe does.
constexpr double kTouching = 2.0 * kStripeHalfWidth + 3.0;
constexpr double kGoes = 1.0;      // cm in kLook; a standing robot sways less
constexpr double kContest = 30.0;  // cm from both neck bases: the ball is played

struct Pair {
  std::size_t pusher;
  std::size_t pushed;
};

bool contested(const MatchScene& scene, Pair pair) {
  const Point2<Field> ball = scene.ball.position;
  return distance(scene.players[pair.pusher].pose.position, ball) < kContest &&
         distance(scene.players[pair.pushed].pose.position, ball) < kContest;
}

bool mayBeFoul(const MatchScene& scene, const body::FieldDescription& field, Pair pair) {
  const ScenePlayer& one = scene.players[pair.pusher];
  const ScenePlayer& other = scene.players[pair.pushed];
  if (!one.playing || !other.playing || one.team == other.team) return false;
  if (one.number == kGoalie && inOwnGoalBox(field, one.team, one.pose.position)) return false;
  return !contested(scene, pair);
}

bool pushes(const MatchScene& scene, const PushingState& state, Pair pair) {
  const Pose2& one = scene.players[pair.pusher].pose;
  const Pose2& other = scene.players[pair.pushed].pose;
  const Pose2& oneBefore = state.before[pair.pusher];
  const Pose2& otherBefore = state.before[pair.pushed];
  if (stripeDistance(one, other) > kTouching || stripeDistance(oneBefore, otherBefore) > kTouching)
    return false;
  const Point2<Field> way = otherBefore.position - oneBefore.position;
  if (way.norm() <= 0.0) return false;
  const auto along = [&](Point2<Field> moved) {
    return (moved.x * way.x + moved.y * way.y) / way.norm();
  };
  return along(one.position - oneBefore.position) >= kGoes &&
         along(other.position - otherBefore.position) >= kGoes;
}

bool foulBy(const MatchScene& scene, const body::FieldDescription& field, double seconds,
            std::size_t pusher, PushingState& state) {
  bool foul = false;
  for (std::size_t i = 0; i < scene.players.size(); ++i) {
    if (i == pusher) continue;
    const Pair pair{pusher, i};
    double& pushed = state.pushed[pusher][i];
    pushed = mayBeFoul(scene, field, pair) && pushes(scene, state, pair) ? pushed + seconds : 0.0;
    foul = foul || pushed > field.rules.pushingTime;
  }
  return foul;
}

}  // namespace

Fouls step(const MatchScene& scene, const body::FieldDescription& field, PushingState& state) {
  Fouls fouls;
  const double seconds = state.looked ? (scene.time - *state.looked).seconds() : kLook;
  if (seconds < kLook) return fouls;
  if (state.before.size() == scene.players.size()) {
    for (std::size_t i = 0; i < scene.players.size(); ++i)
      if (foulBy(scene, field, seconds, i, state)) fouls.push_back({i, Offence::pushing});
  }
  state.looked = scene.time;
  state.before.clear();
  for (const ScenePlayer& player : scene.players) state.before.push_back(player.pose);
  return fouls;
}

}  // namespace kelpie::sim
