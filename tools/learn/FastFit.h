// SPDX-License-Identifier: Apache-2.0
// Makes the kinematic body go as far as its odometry tells, which is fitted to physical bodies: it
// walks at many speeds, and the shares of GroundParams are fitted to what it did and what was told.
#pragma once

#include <vector>

#include "actuator/Feet.h"
#include "tools/sim/RobotModel.h"

namespace kelpie::learn {

struct FastSample {
  actuator::Velocity walked;
  actuator::Velocity told;
};

// `count` even walks of the normal set on that ground, in all directions.
std::vector<FastSample> sampleFast(const sim::GroundParams& ground, int count, std::uint64_t seed);

// Of samples on plain ground.
sim::GroundParams fitGround(const std::vector<FastSample>& samples);

// By how much what was walked differs from what was told, percent of the ways and of the turns.
struct FastError {
  double way = 0.0;
  double turn = 0.0;
};
FastError errorOf(const std::vector<FastSample>& samples);

}  // namespace kelpie::learn
