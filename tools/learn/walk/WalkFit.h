// SPDX-License-Identifier: Apache-2.0
// What comes of the feet's speed: the curves and cross terms of WalkCalibration, a walk's odometry,
// its free load and its sway, fitted by least squares to walks that were measured (WalkSamples.h).
#pragma once

#include <vector>

#include "tools/learn/walk/WalkSamples.h"

namespace kelpie::learn {

// From feet to real speed; and how the way is estimated.
actuator::WalkCalibration fitCalibration(const std::vector<SpeedSample>& samples);
actuator::WalkOdometry fitOdometry(const std::vector<PathSample>& samples);
// What of the load is the walk's own.
actuator::FreeLoad fitFreeLoad(const std::vector<SpeedSample>& samples);
// What is left of the way when `odometry` has estimated it is an oscillation.
actuator::WalkOscillation fitOscillation(const std::vector<OscillationSample>& samples,
                                         const actuator::WalkOdometry& odometry,
                                         const actuator::StrokeLimits& max);

}  // namespace kelpie::learn
