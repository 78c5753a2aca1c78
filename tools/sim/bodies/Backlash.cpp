// SPDX-License-Identifier: Apache-2.0
#include "tools/sim/bodies/Backlash.h"

#include "robot/core/Maths.h"
#include "robot/core/types/FrameInput.h"

namespace kelpie::sim {
namespace {

// The head is in front of both its tilting axes in every posture, so it sinks forward through the
// play, against the friction of the gear [chosen]: 2.5 deg in 0.17 s.
constexpr double kSinks = 0.26;  // rad/s, 15 deg/s

}  // namespace

double Backlash::slackAfter(Gear& gear, double motor, double play, double sinks) const {
  const double moved = begun_ ? motor - gear.motor : 0.0;
  gear.motor = motor;
  gear.slack = maths::clamp(gear.slack - moved - sinks * kTickSeconds, -0.5 * play, 0.5 * play);
  return gear.slack;
}

JointAngles Backlash::step(const JointAngles& motors) {
  JointAngles joints = motors;
  const auto carry = [&](std::size_t gear, Joint joint, Angle play, double sinks) {
    if (play.rad() <= 0.0) return;
    const double slack = slackAfter(gears_[gear], motors[joint].rad(), play.rad(), sinks);
    joints[joint] = motors[joint] + Angle::rad(slack);
  };
  carry(0, Joint::neckTilt, play_.neckTilt, kSinks);
  carry(1, Joint::headPan, play_.headPan, 0.0);
  carry(2, Joint::headNod, play_.headNod, kSinks);
  begun_ = true;
  return joints;
}

}  // namespace kelpie::sim
