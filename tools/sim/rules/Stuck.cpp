// SPDX-License-Identifier: Apache-2.0
#include "tools/sim/rules/Stuck.h"

namespace kelpie::sim {

bool step(const MatchScene& scene, const body::Rules& rules, StuckState& state) {
  const Point2<Field> ball = scene.ball.position;
  const bool somebody = !isFree(scene, ball, rules.stuckReach);
  const bool went = distance(ball, state.place) > rules.stuckDistance;
  if (!state.since || went || !somebody) {
    state.since = scene.time;
    state.place = ball;
    return false;
  }
  return (scene.time - *state.since).seconds() > rules.stuckTime;
}

}  // namespace kelpie::sim
