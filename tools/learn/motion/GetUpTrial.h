// SPDX-License-Identifier: Apache-2.0
// How well a motion brings a fallen robot to its feet: a physical robot is laid on a side, as its
// legs happen to be and turned a little otherwise each time, plays the motion and stands.
#pragma once

#include "tools/learn/walk/PhysicalWalker.h"

namespace kelpie::learn {

// Turns the robot over onto that side, some degrees off, and lets it fall from a few centimetres.
// `none` lays it down upright.
void layDown(FallSide side, std::uint64_t seed, PhysicalWalker& walker);

// The cosine of the trunk's lean: 1 level, 0 on a side, -1 on its back.
double uprightness(PhysicalWalker& walker);
// The side that is really down, for a lean of 60 deg or more.
FallSide trueSide(PhysicalWalker& walker);
// Within 25 deg of level.
bool standsUpright(PhysicalWalker& walker);

MotionKind getUpMotion(FallSide side);

// From 0 to 2, about: the mean over one trial on each model of how upright the robot is in the end,
// and one more where it stands. `seed` draws how it lies. Greater for the one that does it sooner.
double getUpGain(const actuator::MotionData& motion, FallSide side,
                 const std::vector<sim::PhysicsParams>& models, std::uint64_t seed);

}  // namespace kelpie::learn
