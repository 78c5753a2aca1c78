// SPDX-License-Identifier: Apache-2.0
// Makes the kinematic body go as fast as it is asked to, though its walks are calibrated to
// physical bodies: it walks at many speeds, and the shares of GroundParams are fitted to what it
// did.
#pragma once

#include <vector>

#include "actuator/walk/Feet.h"
#include "tools/sim/bodies/RobotModel.h"

namespace kelpie::learn {

struct FastSample {
  actuator::Velocity walked;
  actuator::Velocity asked;
};

// `count` even walks of the normal set on that ground, in all directions.
std::vector<FastSample> sampleFast(const sim::GroundParams& ground, int count, std::uint64_t seed);

// Of samples on plain ground.
sim::GroundParams fitGround(const std::vector<FastSample>& samples);

// By how much what was walked differs from what was asked, percent of the ways and of the turns.
struct FastError {
  double way = 0.0;
  double turn = 0.0;
};
FastError errorOf(const std::vector<FastSample>& samples);

}  // namespace kelpie::learn
