// SPDX-License-Identifier: Apache-2.0
// Walks of a set on one physical model, measured: at even speeds, what the body did and how it
// swayed; with commands that change, what could tell its way. WalkFit.h fits to them.
#pragma once

#include <vector>

#include "tools/learn/walk/WalkTrial.h"

namespace kelpie::learn {

// A walk at an even speed of the feet, and what the body did.
struct SpeedSample {
  actuator::Velocity feet;
  actuator::Velocity real;
  double load = 0.0;  // felt (Feeling.h), the walk's own in it
};

// Half a second of a walk whose commands change: the numbers of AlongTerms and AcrossTerms that its
// way is estimated from (OdometryTerms.h), on average, and the way.
struct PathSample {
  std::vector<double> forward;
  std::vector<double> left;
  std::vector<double> turn;
  actuator::Velocity real;
  double weight = 1.0;  // of its residual in the fit
};

// An instant of a walk: how the body stood then beyond what its legs said, and where it went since
// the instant before.
struct OscillationSample {
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
  std::vector<OscillationSample> oscillations;
};

// `count` speeds within the set's limits on one model, none of them twice, half of them in one
// direction by the set's calibration; a robot that falls is put up again and its sample left out.
// The dribbling walk goes with a held ball.
WalkSamples sampleWalk(WalkKind kind, const actuator::WalkSet& set, const sim::PhysicsParams& model,
                       int count, std::uint64_t seed);

void append(const WalkSamples& more, WalkSamples& all);

// `count` commands as a player gives them, each for half a second to two and a half, with the
// calibration and the free load of the set.
std::vector<PathSample> samplePaths(WalkKind kind, const actuator::WalkSet& set,
                                    const sim::PhysicsParams& model, int count, std::uint64_t seed);

}  // namespace kelpie::learn
