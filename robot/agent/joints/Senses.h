// SPDX-License-Identifier: Apache-2.0
// Where the robot counts the other way than Kelpie: the one place in which a raw number changes its
// sign. docs/robot-contract.md has the sign of every joint and sensor with its public source.
// Inside Kelpie rotators swing all four legs forward for positive angles, and left and up are
// positive (robot/body/Legs.h, robot/core/types/Geometry.h).
#pragma once

#include <array>

#include "robot/core/types/Joints.h"

namespace kelpie::agent {

// 1 where both count alike, -1 where they differ.
struct Senses {
  std::array<double, kJointCount> joints{};  // of angle and motor duty
  std::array<double, 3> acceleration{};      // of a1, a2, a3 as forward, left, up
};

constexpr Senses robotSenses() {
  Senses senses;
  for (double& joint : senses.joints) joint = 1.0;
  // J1 of a hind leg is positive away from the body, so backward (Tekkotsu, ERS7Info.h; the
  // sleeping dog of Sony's sample MovingLegs7 has -119 deg).
  senses.joints[index(Joint::leftHindRotator)] = -1.0;
  senses.joints[index(Joint::rightHindRotator)] = -1.0;
  // A positive pan points the tail to the right (Tekkotsu, ERS7Info.h).
  senses.joints[index(Joint::tailPan)] = -1.0;
  // Positive on its nose, on its right side, and on its back (2005 release, CommonSense.cc).
  senses.acceleration = {-1.0, 1.0, -1.0};
  return senses;
}

}  // namespace kelpie::agent
