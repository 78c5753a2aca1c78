// SPDX-License-Identifier: Apache-2.0
// What comes of the feet's speed, measured: a set walks at many speeds on several models, and the
// curves and cross terms of WalkCalibration, its free load and its sway are fitted to it by least
// squares.
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

// An instant of a walk: how the body stood then beyond what its legs said, and where it went since
// the instant before.
struct SwaySample {
  actuator::Stride stride;
  double tilt = 0.0;    // rad
  double roll = 0.0;    // rad
  double height = 0.0;  // cm
  actuator::Stride before;
  Walked moved;
  Walked joints;         // what the standing feet's joints say of it
  double seconds = 0.0;  // since before
};

struct WalkSamples {
  std::vector<SpeedSample> speeds;
  std::vector<SwaySample> sways;
};

// `count` speeds within the set's limits on one model, none of them twice; a robot that falls is
// put up again and its sample left out. The dribbling walk goes with a held ball.
WalkSamples sampleWalk(WalkKind kind, const actuator::WalkSet& set, const sim::PhysicsParams& model,
                       int count, std::uint64_t seed);

void append(const WalkSamples& more, WalkSamples& all);

// From feet to real speed; and of how it is told.
actuator::WalkCalibration fitCalibration(const std::vector<SpeedSample>& samples);
actuator::WalkOdometry fitOdometry(const std::vector<SpeedSample>& samples,
                                   const actuator::FreeLoad& free);
// What of the load is the walk's own.
actuator::FreeLoad fitFreeLoad(const std::vector<SpeedSample>& samples);
// What is left of the way when `odometry` has told it is a swing.
actuator::WalkSway fitSway(const std::vector<SwaySample>& samples,
                           const actuator::WalkOdometry& odometry,
                           const actuator::StrokeLimits& most);

}  // namespace kelpie::learn
