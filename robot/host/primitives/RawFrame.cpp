// SPDX-License-Identifier: Apache-2.0
#include "robot/host/primitives/RawFrame.h"

#include <cmath>
#include <limits>

#include "robot/core/Maths.h"

namespace kelpie::host {
namespace {

using openr::Sensor;

constexpr std::int32_t kPressedBack = 40;  // above every on threshold of the back sensors (14)

std::int32_t rounded(double value) {
  using Limits = std::numeric_limits<std::int32_t>;
  const double whole = std::floor(value + 0.5);
  if (whole >= Limits::max()) return Limits::max();
  return whole > Limits::min() ? static_cast<std::int32_t>(whole) : Limits::min();
}

// A hind leg's rotator counts away from the body, which is backward: in Sony's sample MovingLegs7
// a sleeping dog's are at -119 deg, thighs forward. A tail that points to the robot's right has a
// positive pan (Tekkotsu, ERS7Info.h).
bool turnedRound(std::size_t joint) {
  switch (static_cast<Joint>(joint)) {
    case Joint::leftHindRotator:
    case Joint::rightHindRotator:
    case Joint::tailPan: return true;
    default: return false;
  }
}

std::int32_t length(double cm, const openr::SensorRange& range) {
  return rounded(maths::clamp(cm, range.min, range.max) / openr::kMicrometre);
}

void set(Sensor sensor, std::int32_t value, RawSensors& raw) {
  raw.sensors[openr::index(sensor)] = value;
}

// Backward, left and down: on its nose +g in the first, on its right side +g in the second, on its
// back +g in the third, and -g in the third when it stands (CommonSense.cc of the 2005 release;
// Tekkotsu, ERS7Info.h).
void setAcceleration(const std::array<double, 3>& forwardLeftUp, RawSensors& raw) {
  const auto& [forward, left, up] = forwardLeftUp;
  set(Sensor::accelerationBack, length(-forward, openr::kAccelerationRange), raw);
  set(Sensor::accelerationLeft, length(left, openr::kAccelerationRange), raw);
  set(Sensor::accelerationDown, length(-up, openr::kAccelerationRange), raw);
}

void setTouch(const SensorFrame& frame, RawSensors& raw) {
  constexpr std::array<Sensor, kLegCount> kPaws = {Sensor::pawLeftFront, Sensor::pawLeftHind,
                                                   Sensor::pawRightFront, Sensor::pawRightHind};
  constexpr std::array<Sensor, 3> kBack = {Sensor::backFront, Sensor::backMiddle, Sensor::backRear};
  for (std::size_t i = 0; i < kPaws.size(); ++i) set(kPaws[i], frame.paw[i] ? 1 : 0, raw);
  for (std::size_t i = 0; i < kBack.size(); ++i)
    set(kBack[i], frame.back[i] ? kPressedBack : 0, raw);
  set(Sensor::chin, frame.chin ? 1 : 0, raw);
  const openr::SensorRange& head = openr::kHeadTouchRange;
  set(Sensor::headTouch, rounded(maths::clamp(frame.headTouch, head.min, head.max)), raw);
}

}  // namespace

RawJoints rawOf(const JointAngles& angles) {
  RawJoints raw;
  for (std::size_t j = 0; j < kJointCount; ++j) {
    const double angle = angles.angle[j].rad();
    raw.value[j] = rounded((turnedRound(j) ? -angle : angle) / openr::kMicroradian);
  }
  return raw;
}

JointAngles anglesOf(const RawJoints& raw) {
  JointAngles angles;
  for (std::size_t j = 0; j < kJointCount; ++j) {
    const double angle = raw.value[j] * openr::kMicroradian;
    angles.angle[j] = Angle::rad(turnedRound(j) ? -angle : angle);
  }
  return angles;
}

RawSensors rawOf(const SensorFrame& frame) {
  RawSensors raw;
  raw.joints = rawOf(frame.joints);
  for (std::size_t j = 0; j < kJointCount; ++j) {
    const double duty = maths::clamp(frame.duty[j], -1.0, 1.0);
    raw.duty[j] = rounded((turnedRound(j) ? -duty : duty) * openr::kFullDuty);
  }
  set(Sensor::headNear, length(frame.headNearDistance, openr::kHeadNearRange), raw);
  set(Sensor::headFar, length(frame.headFarDistance, openr::kHeadFarRange), raw);
  set(Sensor::chest, length(frame.chestDistance, openr::kChestRange), raw);
  setAcceleration(frame.acceleration, raw);
  setTouch(frame, raw);
  return raw;
}

}  // namespace kelpie::host
