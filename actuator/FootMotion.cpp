// SPDX-License-Identifier: Apache-2.0
#include "actuator/FootMotion.h"

#include <cmath>

#include "robot/body/Legs.h"

namespace kelpie::actuator {
namespace {

constexpr double kLow = 0.4;      // cm above the ground: lower feet carry the body
constexpr double kPressed = 0.8;  // cm, with the paw pressed

bool finite(const JointAngles& joints) {
  for (const Angle angle : joints.angle)
    if (!std::isfinite(angle.rad())) return false;
  return true;
}

}  // namespace

body::PlanarMotion stepFootMotion(const SensorFrame& sensors, FootMotionState& state) {
  if (!finite(sensors.joints)) {
    state.known = false;
    return {};
  }
  const Stance stance = body::stanceFromLegs(sensors.joints);
  std::array<Point2<Robot>, kLegCount> before{};
  std::array<Point2<Robot>, kLegCount> now{};
  std::size_t count = 0;
  for (std::size_t i = 0; i < kLegCount; ++i) {
    const auto leg = static_cast<LegId>(i);
    const Point3<Robot> foot =
        body::robotFromTorso(stance, body::footPosition(leg, body::legAngles(sensors.joints, leg)));
    const bool down = foot.z < (sensors.paw[i] ? kPressed : kLow);
    if (state.known && down && state.down[i]) {
      before[count] = {state.feet[i].x, state.feet[i].y};
      now[count++] = {foot.x, foot.y};
    }
    state.feet[i] = foot;
    state.down[i] = down;
  }
  state.known = true;
  return body::rigidMotion(now.data(), before.data(), count);
}

}  // namespace kelpie::actuator
