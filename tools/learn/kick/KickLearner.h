// SPDX-License-Identifier: Apache-2.0
// Learns the key frames of a kick: joint angles and ticks that send the ball as its aim wants it,
// from several places on several physical models at once. A kick found on one place alone goes 1.4
// m from there and 0.6 m from elsewhere (physics.md section 7).
#pragma once

#include "tools/learn/kick/KickTrial.h"
#include "tools/learn/motion/MotionSpace.h"

namespace kelpie::learn {

// `places` on each model.
std::vector<KickStart> beforeKicks(const KickAim& aim,
                                   const std::vector<sim::PhysicsParams>& models, int places,
                                   std::uint64_t seed, BeforeKick before = BeforeKick::rests);
std::vector<Kicked> tryFromAll(const actuator::MotionData& motion, const KickAim& aim,
                               const std::vector<KickStart>& starts);

// Where the ball lies on the mean as the kick begins.
Point2<Robot> meanPlace(const std::vector<KickStart>& starts);

struct KickSpread {
  double distance = 0.0;  // cm, mean
  double distanceSd = 0.0;
  Angle direction;  // mean of those that left
  Angle directionSd;
  int falls = 0;
  int stayed = 0;  // balls that did not leave
  actuator::MotionWay way;
};
KickSpread spreadOf(const std::vector<Kicked>& kicked);
std::string spreadText(const KickSpread& spread, const actuator::MotionData& motion);

double gainOf(const std::vector<Kicked>& kicked, const KickAim& aim,
              const actuator::MotionData& motion);

}  // namespace kelpie::learn
