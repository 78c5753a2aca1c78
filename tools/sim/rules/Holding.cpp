// SPDX-License-Identifier: Apache-2.0
#include "tools/sim/rules/Holding.h"

namespace kelpie::sim {

Fouls step(const MatchScene& scene, const body::Rules& rules, HoldingState& state) {
  Fouls fouls;
  for (std::size_t i = 0; i < scene.players.size(); ++i) {
    HoldWatch& watch = state.watches[i];
    if (!scene.players[i].playing) {
      watch = {};
      continue;
    }
    watch.see(scene.time.seconds(), scene.players[i].pose, scene.ball.position);
    if (!watch.now()) continue;
    const bool far = watch.now()->tooFar(rules);
    if (far || watch.now()->tooLong(rules))
      fouls.push_back({i, far ? Offence::carriedTooFar : Offence::heldTooLong});
  }
  return fouls;
}

}  // namespace kelpie::sim
