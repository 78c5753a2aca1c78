// SPDX-License-Identifier: Apache-2.0
// What each motion is for, as a scene on a physical robot: kicks with the ball where they want it,
// held ones with the ball held, get-ups from the side they are for, blocks with a ball that rolls
// at them. Other motions begin in the stance, without a ball.
#pragma once

#include "tools/learn/motion/MotionPlay.h"

namespace kelpie::learn {

MotionStage sceneOf(MotionKind kind, const actuator::MotionData& motion,
                    const sim::PhysicsParams& model, std::uint64_t seed);

}  // namespace kelpie::learn
