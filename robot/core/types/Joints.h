// SPDX-License-Identifier: Apache-2.0
// The ERS-7's joints in the order in which every array of joints is kept.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "robot/core/Angle.h"
#include "robot/core/fields/Fields.h"

namespace kelpie {

enum class Joint : std::uint8_t {
  neckTilt,  // up positive
  headPan,   // left positive
  headNod,   // up positive
  mouth,     // closed near 0, open negative
  leftFrontRotator,
  leftFrontShoulder,
  leftFrontKnee,
  leftHindRotator,
  leftHindShoulder,
  leftHindKnee,
  rightFrontRotator,
  rightFrontShoulder,
  rightFrontKnee,
  rightHindRotator,
  rightHindShoulder,
  rightHindKnee,
  tailTilt,
  tailPan,
};
constexpr std::size_t kJointCount = 18;
constexpr std::uint32_t kAllJoints = (1U << kJointCount) - 1U;  // bit i: joint i

enum class LegId : std::uint8_t { leftFront, leftHind, rightFront, rightHind };  // OPEN-R r2..r5
constexpr std::size_t kLegCount = 4;

constexpr std::size_t index(Joint joint) { return static_cast<std::size_t>(joint); }
constexpr std::size_t index(LegId leg) { return static_cast<std::size_t>(leg); }
constexpr std::size_t firstJoint(LegId leg) {
  return index(Joint::leftFrontRotator) + 3 * index(leg);
}

struct JointAngles {
  std::array<Angle, kJointCount> angle{};

  Angle& operator[](Joint joint) { return angle[index(joint)]; }
  Angle operator[](Joint joint) const { return angle[index(joint)]; }
  template <int = 0>
  static constexpr auto fields() {
    return fieldList(field("angle", &JointAngles::angle, "rad", -135, 135));
  }
};

// A share of the way of a joint, which cannot turn past its stops: angles are not taken round.
inline Angle partWay(Angle from, Angle to, double share) {
  return Angle::rad(from.rad() + share * (to.rad() - from.rad()));
}

}  // namespace kelpie
