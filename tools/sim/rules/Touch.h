// SPDX-License-Identifier: Apache-2.0
// Who touched the ball last, and whose goal it would be. An own goal is one of a robot that sends a
// ball towards its own goal that was not on its way in, as in football: a shot that it turns in, in
// one touch or in the few of one save, stays the shooter's, and a ball that two are at is of the
// one who plays towards that goal, whoever touches it last: squeezed, it jolts to and fro between
// them.
#pragma once

#include <array>
#include <optional>

#include "tools/sim/rules/MatchScene.h"

namespace kelpie::sim {

// The last touch by a team.
struct TeamTouch {
  std::optional<std::size_t> player;
  TimeUs time;
};

struct TouchState {
  Point2<Field> velocity;  // the ball's, of the step before
  std::optional<std::size_t> last;
  std::optional<std::size_t> scorer;  // whose goal it would be now
  std::optional<std::size_t> saver;   // who touches a shot that was on its way in,
  TimeUs saved;                       // and when its first touch of this save was
  std::array<TeamTouch, 2> teams;     // by TeamColour
};

std::optional<std::size_t> step(const MatchScene& scene, const body::FieldDescription& field,
                                TouchState& state);

}  // namespace kelpie::sim
