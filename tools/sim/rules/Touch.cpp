// SPDX-License-Identifier: Apache-2.0
#include "tools/sim/rules/Touch.h"

#include <cmath>
#include <utility>

#include "tools/sim/HoldWatch.h"

namespace kelpie::sim {
namespace {

// Rolling takes 2.5 % in 1/30 s, 1.8 cm/s in a tick at the fastest of 300 cm/s.
constexpr double kJolt = 3.0;  // cm/s
// From the stripe's line: a kicking leg or a head is 16 cm off, and the ball 4.2.
constexpr double kReach = 20.0;  // cm
// A ball loses 0.75 of its speed in a second, so that it rolls as far as this times its speed.
constexpr double kRoll = 1.33;  // s

// Whether a ball that changes its velocity so may have been pushed by that robot: out of its body
// or away from it.
bool mayPush(const ScenePlayer& player, Point2<Field> ball, Point2<Field> change) {
  const Point2<Field> away = ball - nearestOn(stripeOf(player.pose), ball);
  return away.norm() < kStripeHalfWidth || away.x * change.x + away.y * change.y >= 0.0;
}

// The nearest robot of those that may have changed the ball's velocity so; if none may, of all.
std::optional<std::size_t> nearest(const MatchScene& scene, Point2<Field> change) {
  std::optional<std::size_t> best;
  std::pair<bool, double> least{true, kReach};  // cannot have pushed it; cm away
  for (std::size_t i = 0; i < scene.players.size(); ++i) {
    const ScenePlayer& player = scene.players[i];
    const double away = stripeDistance(player.pose, scene.ball.position);
    if (!player.playing || away > kReach) continue;
    const std::pair rank{!mayPush(player, scene.ball.position, change), away};
    if (rank > least) continue;
    least = rank;
    best = i;
  }
  return best;
}

bool isHeld(const MatchScene& scene) {
  for (const ScenePlayer& player : scene.players)
    if (player.playing && inHold(player.pose, scene.ball.position)) return true;
  return false;
}

// Whether a ball of that velocity would have come into that team's goal.
bool goesIn(const body::FieldDescription& field, TeamColour team, Point2<Field> ball,
            Point2<Field> velocity) {
  const Point2<Field> at = ownView(field, team, ball);
  const Point2<Field> way = ownView(field, team, ball + velocity) - at;
  if (way.y >= 0.0 || at.y > -way.y * kRoll) return false;
  const double x = at.x - way.x * at.y / way.y;
  return std::fabs(x - 0.5 * field.width) < 0.5 * field.goalWidth;
}

}  // namespace

std::optional<std::size_t> step(const MatchScene& scene, const body::FieldDescription& field,
                                TouchState& state) {
  const std::optional<Point2<Field>> before = state.velocity;
  state.velocity = scene.ball.velocity;
  const bool jolted = before && distance(*before, scene.ball.velocity) > kJolt;
  if (!jolted && !isHeld(scene)) return state.last;
  const Point2<Field> change = before ? scene.ball.velocity - *before : Point2<Field>{};
  const auto robot = nearest(scene, change);
  if (!robot) return state.last;
  state.last = robot;
  const TeamColour team = scene.players[*robot].team;
  const bool deflects = before && state.scorer && scene.players[*state.scorer].team != team &&
                        goesIn(field, team, scene.ball.position, *before);
  if (!deflects) state.scorer = robot;
  return state.last;
}

}  // namespace kelpie::sim
