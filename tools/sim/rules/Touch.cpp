// SPDX-License-Identifier: Apache-2.0
#include "tools/sim/rules/Touch.h"

#include <cmath>

namespace kelpie::sim {
namespace {

// A ball loses 0.75 of its speed in a second, so that it rolls as far as this times its speed.
constexpr double kRoll = 1.33;  // s
// A shot that hits legs and chest bounces off them for about so long: the same save.
constexpr TimeUs kSave{300000};
// Who touched the ball so recently is at it still: as long as a save, chosen and not measured.
constexpr TimeUs kAtBall{300000};

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

// Whether that player keeps out, or turns in, what another team has sent into its goal.
bool saves(const MatchScene& scene, const body::FieldDescription& field, std::size_t player,
           const TouchState& state) {
  const bool still = state.saver == player && scene.time - state.saved < kSave;
  return still || goesIn(field, scene.players[player].team, scene.ball.position, state.velocity);
}

// Who of the other team is at the ball, too, if it rolls towards that team's goal.
std::optional<std::size_t> attacks(const MatchScene& scene, const body::FieldDescription& field,
                                   TeamColour team, const TouchState& state) {
  const TeamTouch& other = state.teams[static_cast<std::size_t>(otherTeam(team))];
  const bool goalward = ownWay(field, team, scene.ball.velocity).y < 0.0;
  return goalward && scene.time - other.time < kAtBall ? other.player : std::nullopt;
}

void touch(const MatchScene& scene, const body::FieldDescription& field, std::size_t player,
           TouchState& state) {
  const TeamColour team = scene.players[player].team;
  const bool others = state.scorer && scene.players[*state.scorer].team != team;
  const bool saved = others && saves(scene, field, player, state);
  if (!saved) state.scorer = attacks(scene, field, team, state).value_or(player);
  if (state.saver != player) state.saved = scene.time;
  state.saver = saved ? std::optional(player) : std::nullopt;
  state.last = player;
  state.teams[static_cast<std::size_t>(team)] = {player, scene.time};
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
