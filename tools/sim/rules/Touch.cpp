// SPDX-License-Identifier: Apache-2.0
#include "tools/sim/rules/Touch.h"

#include <cmath>

namespace kelpie::sim {
namespace {

// A ball loses 0.75 of its speed in a second, so that it rolls as far as this times its speed.
constexpr double kRoll = 1.33;  // s
// A shot that hits legs and chest bounces off them for about so long: the same save.
constexpr TimeUs kSave{300000};

// The velocity as that team sees it: y < 0 is towards its goal.
Point2<Field> ownWay(const body::FieldDescription& field, TeamColour team, Point2<Field> velocity) {
  return ownView(field, team, velocity) - ownView(field, team, Point2<Field>{});
}

// Whether a ball of that velocity would have come into that team's goal.
bool goesIn(const body::FieldDescription& field, TeamColour team, Point2<Field> ball,
            Point2<Field> velocity) {
  const Point2<Field> at = ownView(field, team, ball);
  const Point2<Field> way = ownWay(field, team, velocity);
  if (way.y >= 0.0 || at.y > -way.y * kRoll) return false;
  const double x = at.x - way.x * at.y / way.y;
  return std::fabs(x - 0.5 * field.width) < 0.5 * field.goalWidth;
}

// Whether the ball rolls towards that team's goal, and no faster than in the step before.
bool heldUp(const MatchScene& scene, const body::FieldDescription& field, TeamColour team,
            const TouchState& state) {
  const double now = ownWay(field, team, scene.ball.velocity).y;
  return now < 0.0 && now >= ownWay(field, team, state.velocity).y;
}

// Whether that player keeps out, or turns in, what another team has sent into its goal.
bool saves(const MatchScene& scene, const body::FieldDescription& field, std::size_t player,
           const TouchState& state) {
  const bool still = state.saver == player && scene.time - state.saved < kSave;
  return still || goesIn(field, scene.players[player].team, scene.ball.position, state.velocity);
}

// Whether it presses against a ball that would not come in.
bool presses(const MatchScene& scene, const body::FieldDescription& field, std::size_t player,
             const TouchState& state) {
  const TeamColour team = scene.players[player].team;
  return !goesIn(field, team, scene.ball.position, scene.ball.velocity) &&
         heldUp(scene, field, team, state);
}

void touch(const MatchScene& scene, const body::FieldDescription& field, std::size_t player,
           TouchState& state) {
  const bool others =
      state.scorer && scene.players[*state.scorer].team != scene.players[player].team;
  const bool saved = others && saves(scene, field, player, state);
  const bool pressed = others && presses(scene, field, player, state);
  if (!saved && !pressed) state.scorer = player;
  if (state.saver != player) state.saved = scene.time;
  state.saver = saved ? std::optional(player) : std::nullopt;
  state.last = player;
}

}  // namespace

std::optional<std::size_t> step(const MatchScene& scene, const body::FieldDescription& field,
                                TouchState& state) {
  const auto toucher = scene.ballToucher;
  if (toucher && scene.players[*toucher].playing) touch(scene, field, *toucher, state);
  state.velocity = scene.ball.velocity;
  return state.last;
}

}  // namespace kelpie::sim
