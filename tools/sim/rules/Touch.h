// SPDX-License-Identifier: Apache-2.0
// Who touched the ball last, and whose goal it would be. An own goal is one of a robot that sends a
// ball towards its own goal that was not on its way in, as in football: a shot that it turns in, in
// one touch or in the few of one save, stays the shooter's, and a ball that two press in is of who
// presses towards that goal.
#pragma once

#include <optional>

#include "tools/sim/rules/MatchScene.h"

namespace kelpie::sim {

struct TouchState {
  Point2<Field> velocity;  // the ball's, of the step before
  std::optional<std::size_t> last;
  std::optional<std::size_t> scorer;  // whose goal it would be now
  std::optional<std::size_t> saver;   // who touches a shot that was on its way in,
  TimeUs saved;                       // and when its first touch of this save was
};

std::optional<std::size_t> step(const MatchScene& scene, const body::FieldDescription& field,
                                TouchState& state);

}  // namespace kelpie::sim
