// SPDX-License-Identifier: Apache-2.0
#include "tools/broadcast/Gait.h"

#include <algorithm>
#include <cmath>

#include "robot/body/Ers7.h"
#include "robot/body/Legs.h"

namespace kelpie::broadcast {
namespace {

constexpr double kStride = 9.0;    // cm of way for a step of both pairs
constexpr double kSwing = 2.2;     // cm ahead and behind
constexpr double kLift = 1.6;      // cm
constexpr double kFullPace = 8.0;  // cm/s from which the steps are whole

}  // namespace

JointAngles walkingJoints(const Stance& stance, double way, double pace) {
  JointAngles joints;
  const double share = std::clamp(std::fabs(pace) / kFullPace, 0.0, 1.0);
  for (std::size_t i = 0; i < kLegCount; ++i) {
    const auto leg = static_cast<LegId>(i);
    const bool right = leg == LegId::rightFront || leg == LegId::rightHind;
    const bool second = right == body::isFront(leg);
    const double phase = 2.0 * maths::kPi * way / kStride + (second ? maths::kPi : 0.0);
    const Point3<Robot> shoulder =
        body::robotFromTorso(stance, {(right ? 0.5 : -0.5) * body::kBodyWidth,
                                      body::isFront(leg) ? 0.0 : -body::kBodyLength, 0.0});
    const Point3<Robot> foot{shoulder.x, shoulder.y - share * kSwing * std::cos(phase),
                             share * kLift * std::max(0.0, std::sin(phase))};
    body::setLegAngles(joints, leg,
                       body::reachFoot(leg, body::torsoFromRobot(stance, foot)).angles);
  }
  joints[Joint::neckTilt] = Angle::deg(-20.0);
  joints[Joint::headNod] = Angle::deg(10.0);
  joints[Joint::mouth] = Angle::deg(-3.0);
  return joints;
}

}  // namespace kelpie::broadcast
