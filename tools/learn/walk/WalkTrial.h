// SPDX-License-Identifier: Apache-2.0
// How a walk does on one physical model: how fast it goes when all is asked of it in a direction,
// how far from level the body is, and whether random commands make it fall.
#pragma once

#include <array>
#include <cstdint>

#include "tools/learn/walk/PhysicalWalker.h"

namespace kelpie::learn {

// The directions that a set is judged by, in this order everywhere.
enum class WalkWay : std::uint8_t { forward, back, left, turn };
constexpr std::size_t kWalkDirections = 4;

// Feet that go that share of what the set lets them.
WalkRequest shareOf(WalkWay way, double share, const actuator::WalkSet& set, WalkKind kind);

// What was really done, in the robot's own frame, summed over its turns.
struct Walked {
  double forward = 0.0;  // cm
  double left = 0.0;     // cm
  double turn = 0.0;     // rad
};

Walked& operator+=(Walked& sum, const Walked& more);
// Until the actuator has taken the weak walk.
void spare(PhysicalWalker& walker);
// One step of 32 ms.
Walked walkOn(PhysicalWalker& walker, const Command& command);

struct WalkTrialPlan {
  WalkKind kind = WalkKind::normal;
  double startSeconds = 0.9;     // until the speed is even
  double measuredSeconds = 1.5;  // in each direction, and as long at half the speed
  double randomSeconds = 6.0;    // of random commands, a new one each second
};

struct WalkTrial {
  std::array<double, kWalkDirections>
      speed{};  // cm/s, and rad/s, of feet that go as far as they may
  std::array<double, kWalkDirections> half{};  // of feet at half of that
  double bend = 0.0;                           // rad a cm, largest turn of a straight walk
  double oscillation = 0.0;                    // rad, rms of roll and of tilt about its mean
  bool fell = false;
  double lost = 0.0;  // share of the straight walks and turns that a held ball did not stand
};

// The dribbling walk goes with a held ball.
WalkTrial tryWalk(const WalkTrialPlan& plan, const sim::PhysicsParams& model,
                  const actuator::ActuatorParams& params, std::uint64_t seed);

}  // namespace kelpie::learn
