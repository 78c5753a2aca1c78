// SPDX-License-Identifier: Apache-2.0
// Learns one walk set: the numbers of its stance, gait and stroke limits that make it fast on
// several physical models at once, without a fall. What is learnt on one model alone is brittle
// (physics.md section 4: 40 cm/s fell to 20), so that the slowest model counts as much as the mean.
#pragma once

#include "tools/learn/Search.h"
#include "tools/learn/walk/WalkTrial.h"

namespace kelpie::learn {

// What of a set is searched: all of it, or the gait alone, since kicks begin in a stance.
enum class WalkPart : std::uint8_t { whole, gait };

// What is wanted of a set: the speed in each direction that counts as 1, and how much it counts.
struct WalkAim {
  std::array<double, kWalkDirections> speed{40.0, 32.0, 28.0, 3.4};  // cm/s, rad/s
  std::array<double, kWalkDirections> weight{1.0, 1.0, 1.0, 1.0};
  // What makes a walk hard to predict: speeds that differ from model to model, half the stroke that
  // is not half the speed, straight walks that bend.
  double spreadCosts = 4.0;       // a share of the speed
  double unevenCosts = 0.5;       // so
  double bendCosts = 400.0;       // a rad/cm: 3 deg a metre cost 0.2
  double oscillationCosts = 3.0;  // a rad
};
WalkAim aimOf(WalkKind kind);

SearchSpace walkSpace(WalkKind kind, WalkPart part, const actuator::WalkSet& start);
actuator::WalkSet walkOf(const std::vector<double>& point, WalkPart part,
                         const actuator::WalkSet& start);

// The models of a seed: all differ.
std::vector<sim::PhysicsParams> variedModels(std::uint64_t seed, int count, double step);

// The trials of a set on all models, on as many cores as there are.
std::vector<WalkTrial> tryOnAll(const WalkTrialPlan& plan, const actuator::WalkSet& set,
                                const std::vector<sim::PhysicsParams>& models, std::uint64_t seed);

double gainOf(const std::vector<WalkTrial>& trials, const WalkAim& aim);

}  // namespace kelpie::learn
