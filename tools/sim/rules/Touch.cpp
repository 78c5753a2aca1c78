// SPDX-License-Identifier: Apache-2.0
#include "tools/sim/rules/Touch.h"

#include "tools/sim/HoldWatch.h"

namespace kelpie::sim {
namespace {

// Rolling takes 2.5 % in 1/30 s, 1.8 cm/s in a tick at the fastest of 300 cm/s.
constexpr double kJolt = 3.0;  // cm/s
// From the stripe's line: a kicking leg or a head is 16 cm off, and the ball 4.2.
constexpr double kReach = 20.0;  // cm

std::optional<std::size_t> nearest(const MatchScene& scene) {
  std::optional<std::size_t> best;
  double least = kReach;
  for (std::size_t i = 0; i < scene.players.size(); ++i) {
    const ScenePlayer& player = scene.players[i];
    const double away = stripeDistance(player.pose, scene.ball.position);
    if (!player.playing || away > least) continue;
    least = away;
    best = i;
  }
  return best;
}

bool isHeld(const MatchScene& scene) {
  for (const ScenePlayer& player : scene.players)
    if (player.playing && inHold(player.pose, scene.ball.position)) return true;
  return false;
}

}  // namespace

std::optional<std::size_t> step(const MatchScene& scene, TouchState& state) {
  const bool jolted = state.velocity && distance(*state.velocity, scene.ball.velocity) > kJolt;
  state.velocity = scene.ball.velocity;
  if (jolted || isHeld(scene))
    if (const auto robot = nearest(scene)) state.last = robot;
  return state.last;
}

}  // namespace kelpie::sim
