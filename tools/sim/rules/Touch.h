// SPDX-License-Identifier: Apache-2.0
// Who touched the ball last. There are no contacts to be seen, so: when the ball's velocity changes
// by more than rolling and the carpet do, or a robot holds it, the robot nearest to it touched it,
// if it is near enough; of two beside it the one that it jumps away from: who kicks it past a
// goalie stands farther off than the goalie. A ball that jumps off a post beside a robot is laid at
// its door too. A shot that a robot turns into its own goal stays the shooter's, as in football: an
// own goal is one of a ball that was not on its way in.
#pragma once

#include <optional>

#include "tools/sim/rules/MatchScene.h"

namespace kelpie::sim {

struct TouchState {
  std::optional<Point2<Field>> velocity;  // the ball's, of the step before
  std::optional<std::size_t> last;
  std::optional<std::size_t> scorer;  // whose goal it would be now
};

std::optional<std::size_t> step(const MatchScene& scene, const body::FieldDescription& field,
                                TouchState& state);

}  // namespace kelpie::sim
