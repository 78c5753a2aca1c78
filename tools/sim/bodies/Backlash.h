// SPDX-License-Identifier: Apache-2.0
// The play of the head's three gears: the head is carried by the sensed joint only at the ends of a
// dead zone. Inside it the head stays behind while the joint moves, and sinks by its own weight.
// Keeps where in the dead zone each joint is; the head's mass beyond that (overshoot) is left out.
#pragma once

#include <array>

#include "robot/core/fields/Fields.h"
#include "robot/core/types/Joints.h"

namespace kelpie::sim {

// The whole dead zones.
struct NeckPlay {
  Angle neckTilt;
  Angle headPan;
  Angle headNod;

  template <int = 0>
  static constexpr auto fields() {
    return fieldList(field("neckTilt", &NeckPlay::neckTilt, "rad", 0, 20),
                     field("headPan", &NeckPlay::headPan, "rad", 0, 20),
                     field("headNod", &NeckPlay::headNod, "rad", 0, 20));
  }
};

class Backlash {
 public:
  explicit Backlash(const NeckPlay& play) : play_(play) {}

  // Where the head really is, one tick after the last call, when the motors are there.
  JointAngles step(const JointAngles& motors);

 private:
  struct Gear {
    double motor = 0.0;  // rad, at the last step
    double slack = 0.0;  // rad, of the head over the motor
  };
  double slackAfter(Gear& gear, double motor, double play, double sinks) const;

  NeckPlay play_;
  std::array<Gear, 3> gears_{};
  bool begun_ = false;
};

}  // namespace kelpie::sim
