// SPDX-License-Identifier: Apache-2.0
// Who touched the ball last, and whose goal it would be. A shot that a robot turns into its own
// goal stays the shooter's, as in football: an own goal is one of a ball that was not on its way
// in.
#pragma once

#include <optional>

#include "tools/sim/rules/MatchScene.h"

namespace kelpie::sim {

struct TouchState {
  Point2<Field> velocity;  // the ball's, of the step before
  std::optional<std::size_t> last;
  std::optional<std::size_t> scorer;  // whose goal it would be now
};

std::optional<std::size_t> step(const MatchScene& scene, const body::FieldDescription& field,
                                TouchState& state);

}  // namespace kelpie::sim
