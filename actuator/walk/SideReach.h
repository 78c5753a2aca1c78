// SPDX-License-Identifier: Apache-2.0
// A number for each joint of the two legs on one side: their reach (Reach.h), or what share of the
// way it tells (WalkOdometry.h).
#pragma once

#include "robot/core/fields/Fields.h"

namespace kelpie::actuator {

struct SideReach {
  double frontRotator = 0.0;
  double frontShoulder = 0.0;
  double frontKnee = 0.0;
  double hindRotator = 0.0;
  double hindShoulder = 0.0;
  double hindKnee = 0.0;

  template <int = 0>
  static constexpr auto fields() {
    using P = SideReach;
    return fieldList(field("frontRotator", &P::frontRotator, "", -50, 50),
                     field("frontShoulder", &P::frontShoulder, "", -50, 50),
                     field("frontKnee", &P::frontKnee, "", -50, 50),
                     field("hindRotator", &P::hindRotator, "", -50, 50),
                     field("hindShoulder", &P::hindShoulder, "", -50, 50),
                     field("hindKnee", &P::hindKnee, "", -50, 50));
  }
};

constexpr SideReach operator*(const SideReach& reach, double factor) {
  return {reach.frontRotator * factor, reach.frontShoulder * factor, reach.frontKnee * factor,
          reach.hindRotator * factor,  reach.hindShoulder * factor,  reach.hindKnee * factor};
}

// Of the products, joint by joint.
constexpr double sum(const SideReach& a, const SideReach& b) {
  return a.frontRotator * b.frontRotator + a.frontShoulder * b.frontShoulder +
         a.frontKnee * b.frontKnee + a.hindRotator * b.hindRotator +
         a.hindShoulder * b.hindShoulder + a.hindKnee * b.hindKnee;
}

}  // namespace kelpie::actuator
