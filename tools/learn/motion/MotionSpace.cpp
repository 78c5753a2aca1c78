// SPDX-License-Identifier: Apache-2.0
#include "tools/learn/motion/MotionSpace.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "robot/body/Ers7.h"

namespace kelpie::learn {
namespace {

using actuator::KeyFrame;
using actuator::KeyLegs;
using actuator::kLegJoints;
using actuator::MotionData;

constexpr double kMinTicks = 3.0;
constexpr double kMaxTicks = 30.0;
constexpr std::size_t kSide = kLegJoints / 2;  // joints of the legs of one side: left ones first

bool alike(const MotionData& motion) {
  return std::all_of(motion.frames.begin(), motion.frames.end(), [](const KeyFrame& key) {
    const bool legs =
        std::equal(key.angles.begin(), key.angles.begin() + kSide, key.angles.begin() + kSide);
    return legs && key.head[1] == Angle();
  });
}

// Calls of(name, angle, joint) for each angle that is searched.
template <class Motion, class Of>
void eachAngle(Motion& motion, Of&& of) {
  const bool both = alike(motion);
  for (std::size_t f = 0; f < motion.frames.size(); ++f) {
    auto& key = motion.frames[f];
    if (key.legs != KeyLegs::angles) continue;
    for (std::size_t j = 0; j < (both ? kSide : kLegJoints); ++j)
      of(fmt::format("{}.leg{}", f, j), key.angles[j], index(Joint::leftFrontRotator) + j);
    for (std::size_t j = 0; key.movesHead && j < 3; ++j)
      if (!both || j != 1) of(fmt::format("{}.head{}", f, j), key.head[j], j);
  }
}

void copyToTheRight(MotionData& motion) {
  for (KeyFrame& key : motion.frames)
    std::copy(key.angles.begin(), key.angles.begin() + kSide, key.angles.begin() + kSide);
}

}  // namespace

SearchSpace motionSpace(const MotionData& start, Angle reach) {
  SearchSpace space;
  const auto add = [&](const std::string& name, double value, double min, double max) {
    space.names.push_back(name);
    space.min.push_back(min);
    space.max.push_back(max);
    space.start.push_back(value);
  };
  for (std::size_t f = 0; f < start.frames.size(); ++f)
    if (start.frames[f].legs == KeyLegs::angles)
      add(fmt::format("{}.ticks", f), start.frames[f].ticks, kMinTicks, kMaxTicks);
  eachAngle(start, [&](const std::string& name, Angle angle, std::size_t joint) {
    const body::JointRange range = body::kJointRanges[joint];
    const double value = maths::clamp(angle.deg(), range.min, range.max);
    add(name, value, std::fmax(range.min, value - reach.deg()),
        std::fmin(range.max, value + reach.deg()));
  });
  return space;
}

MotionData motionOf(const std::vector<double>& point, const MotionData& start) {
  MotionData motion = start;
  const bool both = alike(start);
  std::size_t next = 0;
  for (KeyFrame& key : motion.frames)
    if (key.legs == KeyLegs::angles) key.ticks = static_cast<std::uint32_t>(point[next++] + 0.5);
  eachAngle(motion, [&](const std::string&, Angle& angle, std::size_t) {
    angle = Angle::deg(point[next++]);
  });
  if (both) copyToTheRight(motion);
  return motion;
}

MotionData mirrored(const MotionData& motion) {
  MotionData other = motion;
  for (KeyFrame& key : other.frames) {
    std::rotate(key.angles.begin(), key.angles.begin() + kSide, key.angles.end());
    key.head[1] = Angle() - key.head[1];
    key.walk.left = 0.0 - key.walk.left;
    key.walk.turn = 0.0 - key.walk.turn;
  }
  other.way.left = 0.0 - other.way.left;
  other.way.turn = Angle() - other.way.turn;
  other.kick.left = 0.0 - other.kick.left;
  other.kick.direction = Angle() - other.kick.direction;
  return other;
}

}  // namespace kelpie::learn
