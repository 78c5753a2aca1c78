// SPDX-License-Identifier: Apache-2.0
#include "actuator/JointLimits.h"

#include <cmath>

#include "robot/body/Legs.h"

namespace kelpie::actuator {

JointAngles limited(const JointAngles& wanted, const JointAngles& last, const SlewLimits& slew) {
  const JointAngles inside = body::withinLimits(wanted);
  JointAngles result = last;
  for (std::size_t j = 0; j < kJointCount; ++j) {
    const bool leg = j >= index(Joint::leftFrontRotator) && j <= index(Joint::rightHindKnee);
    const double most = leg ? slew.legs.rad() : slew.head.rad();
    const double change = inside.angle[j].rad() - last.angle[j].rad();
    if (!std::isfinite(change)) continue;
    result.angle[j] = std::fabs(change) <= most
                          ? inside.angle[j]
                          : Angle::rad(last.angle[j].rad() + std::copysign(most, change));
  }
  return result;
}

}  // namespace kelpie::actuator
