// SPDX-License-Identifier: Apache-2.0
// Makes the kinematic body walk as the physical one: both walk at the same speeds of the feet, and
// the shares of GroundParams are fitted to what they did.
#pragma once

#include "tools/learn/WalkFit.h"
#include "tools/sim/RobotModel.h"

namespace kelpie::learn {

// What the standard kinematic robot with that ground does at the speeds of the samples' feet.
std::vector<actuator::Velocity> kinematicSpeeds(const std::vector<SpeedSample>& samples,
                                                const sim::GroundParams& ground,
                                                std::uint64_t seed);

// `walked`: on plain ground.
sim::GroundParams fitGround(const std::vector<SpeedSample>& samples,
                            const std::vector<actuator::Velocity>& walked);

}  // namespace kelpie::learn
