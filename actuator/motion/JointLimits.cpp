// SPDX-License-Identifier: Apache-2.0
#include "actuator/motion/JointLimits.h"

#include <cmath>

#include "robot/body/Ers7.h"
#include "robot/body/Legs.h"

namespace kelpie::actuator {
namespace {

constexpr double kRounding = 1e-9;  // deg

// The body is in the way of a shoulder whose rotator is far out, and each turns at its own rate: a
// shoulder that comes down waits for the rotator, a rotator that goes out for the shoulder.
void keepClear(LegId leg, const JointAngles& last, JointAngles& now) {
  Angle& rotator = now.angle[firstJoint(leg)];
  Angle& shoulder = now.angle[firstJoint(leg) + 1];
  const Angle before = last.angle[firstJoint(leg) + 1];
  const auto lowest = [leg](Angle at) { return body::lowestShoulder(leg, at.deg()); };
  if (shoulder.deg() >= lowest(rotator) - kRounding) return;
  if (before.deg() < lowest(rotator) - kRounding) rotator = last.angle[firstJoint(leg)];
  const double min = std::fmin(before.deg(), lowest(rotator));
  if (shoulder.deg() < min) shoulder = Angle::deg(min);
}

}  // namespace

JointAngles limited(const JointAngles& wanted, const JointAngles& last, const SlewLimits& slew) {
  const JointAngles inside = body::withinLimits(wanted);
  JointAngles result = last;
  for (std::size_t j = 0; j < kJointCount; ++j) {
    const bool leg = j >= index(Joint::leftFrontRotator) && j <= index(Joint::rightHindKnee);
    const double max = leg ? slew.legs.rad() : slew.head.rad();
    const double change = inside.angle[j].rad() - last.angle[j].rad();
    if (!std::isfinite(change)) continue;
    result.angle[j] = std::fabs(change) <= max
                          ? inside.angle[j]
                          : Angle::rad(last.angle[j].rad() + std::copysign(max, change));
  }
  for (std::size_t leg = 0; leg < kLegCount; ++leg)
    keepClear(static_cast<LegId>(leg), last, result);
  return result;
}

}  // namespace kelpie::actuator
