// SPDX-License-Identifier: Apache-2.0
// What comes of the feet's speed, measured: a set walks at many speeds on several models, and the
// curves and cross terms of WalkCalibration are fitted to it by least squares.
#pragma once

#include <vector>

#include "tools/learn/WalkTrial.h"

namespace kelpie::learn {

// A walk at an even speed of the feet, and what the body did.
struct SpeedSample {
  actuator::Velocity feet;
  actuator::Velocity real;
  actuator::Velocity joints;  // what the standing feet's joints say of it
  double load = 0.0;          // felt (Feeling.h), the walk's own in it
};

// `count` speeds within the set's limits on one model, none of them twice; a robot that falls is
// put up again and its sample left out.
std::vector<SpeedSample> sampleSpeeds(WalkKind kind, const actuator::WalkSet& set,
                                      const sim::PhysicsParams& model, int count,
                                      std::uint64_t seed);

// From feet to real speed; and of how it is told.
actuator::WalkCalibration fitCalibration(const std::vector<SpeedSample>& samples);
actuator::WalkOdometry fitOdometry(const std::vector<SpeedSample>& samples);
// What of the load is the walk's own.
actuator::FreeLoad fitFreeLoad(const std::vector<SpeedSample>& samples);

}  // namespace kelpie::learn
