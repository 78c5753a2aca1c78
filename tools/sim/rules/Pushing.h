// SPDX-License-Identifier: Apache-2.0
// A robot that pushes one of the other team. Contacts cannot be seen, only places, looked at every
// half second, which is about one step: one pushes another when they touched before and now, it
// went towards the other, and the other gave way in that direction. Who does so for pushingTime
// without a break commits the foul. No foul is counted while the ball is within reach of both, who
// then play it, nor of a goalie in its own goal box. Of two that shove each other the one that
// gains ground is the pusher. Cannot tell a robot that is pushed from one that walks away with
// somebody at its heels.
#pragma once

#include <array>
#include <optional>

#include "tools/sim/rules/Fouls.h"

namespace kelpie::sim {

struct PushingState {
  std::optional<TimeUs> looked;
  FixedVector<Pose2, kMaxRobots> before;
  // How long the one has pushed the other: [pusher][pushed], s.
  std::array<std::array<double, kMaxRobots>, kMaxRobots> pushed{};
};

Fouls step(const MatchScene& scene, const body::FieldDescription& field, PushingState& state);

}  // namespace kelpie::sim
