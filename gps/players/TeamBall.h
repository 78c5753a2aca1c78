// SPDX-License-Identifier: Apache-2.0
// One ball out of what the team saw: the product of the Gaussians of the largest group of robots
// that agree pairwise (chi-square), not the pick of the surest one. A robot with a wrong pose is
// outvoted by two; one against one, the surer is believed.
#pragma once

#include "gps/OnField.h"
#include "gps/players/PlayersContext.h"
#include "gps/players/PlayersState.h"

namespace kelpie::gps {

struct Witness {
  Place place;
  Point2<Field> velocity;
  double secondsSinceSeen = 0.0;
};

using Witnesses = FixedVector<Witness, kTeammates + 1>;

// The ball of a message, rolled on since it was made.
Witness witnessOf(const TeamMessage& message, const PlayersContext& context);

// The balls that the team saw recently, the own included; those of mates have rolled on to now.
Witnesses witnessesOf(const BallEstimate& own, const Teammates& mates,
                      const PlayersContext& context);

TeamBall fused(const Witnesses& witnesses, const TeamBallParams& params);

}  // namespace kelpie::gps
