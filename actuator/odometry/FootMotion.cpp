// SPDX-License-Identifier: Apache-2.0
#include "actuator/odometry/FootMotion.h"

#include <cmath>

namespace kelpie::actuator {
namespace {

constexpr double kLow = 0.4;      // cm above the ground: lower feet carry the body
constexpr double kPressed = 0.8;  // cm, with the paw pressed

SupportPlace placeOf(std::size_t i, const body::Lean& lean, const body::AllTurns& turns,
                     const SensorFrame& sensors) {
  const LegId leg = body::legOfSupport(i);
  const body::LegTurns& ofLeg = turns[index(leg)];
  const body::Support paw = body::supportOf(index(leg), ofLeg);
  const body::Support support = body::supportOf(i, ofLeg);
  const Point3<Torso> tip = body::footPosition(leg, ofLeg);
  const Point3<Robot> way =
      body::robotFromTorso(lean, tip) - body::robotFromTorso(lean, paw.middle);
  SupportPlace place;
  place.middle = body::robotFromTorso(lean, support.middle);
  place.legWay = {way.x / paw.radius, way.y / paw.radius, way.z / paw.radius};
  place.radius = support.radius;
  place.down = place.middle.z - place.radius < (sensors.paw[index(leg)] ? kPressed : kLow);
  return place;
}

// Where the point that touched the ground is after the lower leg turned a little: the middle alone
// would miss by what the sphere rolls, some percent of a step.
Point2<Robot> rolledFrom(const SupportPlace& before, const SupportPlace& now) {
  const Point3<Robot>& a = before.legWay;
  const Point3<Robot>& b = now.legWay;
  const double aboutX = now.radius * (a.y * b.z - a.z * b.y);
  const double aboutY = now.radius * (a.z * b.x - a.x * b.z);
  return {now.middle.x - aboutY, now.middle.y + aboutX};
}

bool finite(const JointAngles& joints) {
  for (const Angle angle : joints.angle)
    if (!std::isfinite(angle.rad())) return false;
  return true;
}

}  // namespace

SensedPose poseOf(const SensorFrame& sensors) {
  const body::AllTurns turns = body::turnsOf(sensors.joints);
  return {turns, body::stanceFromLegs(turns)};
}

body::PlanarMotion stepFootMotion(const SensorFrame& sensors, FootMotionState& state) {
  return stepFootMotion(sensors, poseOf(sensors), state);
}

body::PlanarMotion stepFootMotion(const SensorFrame& sensors, const SensedPose& pose,
                                  FootMotionState& state) {
  if (!finite(sensors.joints)) {
    state.known = false;
    return {};
  }
  const body::Lean lean(pose.stance);
  std::array<Point2<Robot>, body::kSupportCount> before{};
  std::array<Point2<Robot>, body::kSupportCount> now{};
  std::size_t count = 0;
  for (std::size_t i = 0; i < body::kSupportCount; ++i) {
    SupportPlace& was = state.supports[i];
    const SupportPlace is = placeOf(i, lean, pose.turns, sensors);
    if (state.known && is.down && was.down) {
      before[count] = {was.middle.x, was.middle.y};
      now[count++] = rolledFrom(was, is);
    }
    was = is;
  }
  state.known = true;
  return body::rigidMotion(now.data(), before.data(), count);
}

}  // namespace kelpie::actuator
