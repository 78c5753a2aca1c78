// SPDX-License-Identifier: Apache-2.0
// The forward kick: a chest push. All feet stay on the ground while the body leans back and is then
// thrown forward against the ball. The chest is flat, so the ball leaves along the body's axis
// wherever it lies between the paws (a paw or the head, being round, turns 1 cm aside into 10 deg).
#pragma once

#include <cstdint>

#include "actuator/ActuatorParams.h"
#include "actuator/ActuatorState.h"

namespace kelpie::actuator {

std::uint32_t chestKickTicks(const KickParams& kick);

// How far the body is ahead of its place at a tick of the kick, cm.
double chestKickLean(std::uint32_t tick, const KickParams& kick);

// One tick: moves the feet against the body; sets the velocity of the body for the odometry.
void stepChestKick(std::uint32_t tick, const ActuatorParams& params, GaitState& state);

}  // namespace kelpie::actuator
