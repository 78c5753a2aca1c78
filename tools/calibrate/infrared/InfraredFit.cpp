// SPDX-License-Identifier: Apache-2.0
#include "tools/calibrate/infrared/InfraredFit.h"

#include <algorithm>
#include <cmath>

#include "robot/core/Maths.h"

namespace kelpie::calibrate {
namespace {

constexpr double kShare = 0.8;      // of the carpet's reading
constexpr double kMinSpread = 3.0;  // cm, sd of the distances that a line is drawn through

struct Pair {
  double own;   // cm, as read
  double base;  // cm, as the base robot's line has it
};

std::vector<Pair> pairsOf(const CarpetLog& own, const CarpetLog& base) {
  std::vector<Pair> pairs;
  for (const CarpetReadings& mine : own.poses)
    for (const CarpetReadings& other : base.poses)
      if (mine.pose == other.pose) pairs.push_back({mine.mean, base.infrared.asBase(other.mean)});
  return pairs;
}

Pair meanOf(const std::vector<Pair>& pairs) {
  Pair sum{0.0, 0.0};
  for (const Pair& pair : pairs) {
    sum.own += pair.own;
    sum.base += pair.base;
  }
  const auto count = static_cast<double>(pairs.size());
  return {sum.own / count, sum.base / count};
}

}  // namespace

Expected<CarpetThreshold> carpetThreshold(const CarpetLog& log) {
  CarpetThreshold found;
  double sum = 0.0;
  for (const CarpetReadings& held : log.poses) {
    if (!isBallStance(held.pose)) continue;
    found.readings += held.count;
    sum += static_cast<double>(held.count) * log.infrared.asBase(held.mean);
  }
  if (found.readings == 0)
    return Error{"the robot never stands as with a ball: neck -52, nod 45 deg, mouth open"};
  found.carpet = sum / static_cast<double>(found.readings);
  found.threshold = kShare * found.carpet;
  return found;
}

Expected<InfraredLine> lineBetween(const CarpetLog& own, const CarpetLog& base) {
  const std::vector<Pair> pairs = pairsOf(own, base);
  if (pairs.size() < 2)
    return Error{"holds its head in " + std::to_string(pairs.size()) +
                 " of the base robot's poses, two are needed"};
  const Pair mean = meanOf(pairs);
  double spread = 0.0;
  double product = 0.0;
  for (const Pair& pair : pairs) {
    spread += maths::square(pair.own - mean.own);
    product += (pair.own - mean.own) * (pair.base - mean.base);
  }
  const auto count = static_cast<double>(pairs.size());
  if (spread < count * maths::square(kMinSpread))
    return Error{"the carpet is equally far in all poses: no line goes through one point"};
  InfraredLine line;
  line.poses = pairs.size();
  line.gain = product / spread;
  line.offset = mean.base - line.gain * mean.own;
  double left = 0.0;
  for (const Pair& pair : pairs)
    left += maths::square(line.gain * pair.own + line.offset - pair.base);
  line.rms = std::sqrt(left / count);
  return line;
}

}  // namespace kelpie::calibrate
