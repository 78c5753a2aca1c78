// SPDX-License-Identifier: Apache-2.0
// What the robot's joints and sensors count, in OPEN-R's units and in the robot's own signs, which
// are not Kelpie's everywhere. A world sends sensors in it and receives targets in it, so that what
// the agent makes of a raw number is put to the test with every message (docs/robot-contract.md has
// each sign and its source). This file turns a world's frames into what the robot would tell; the
// agent's way back is its own (robot/agent/AgentIo) and shares no sign with it.
#pragma once

#include <array>
#include <cstdint>

#include "robot/core/types/Motion.h"
#include "robot/openr/Ers7Primitives.h"

namespace kelpie::host {

struct RawJoints {
  std::array<std::int32_t, kJointCount> value{};  // urad, in the order of Joint

  template <int = 0>
  static constexpr auto fields() {
    return fieldList(field("value", &RawJoints::value, "urad"));
  }
};

// One tick of 8 ms.
struct RawSensors {
  RawJoints joints;
  std::array<std::int32_t, kJointCount> duty{};             // pwmDuty, -512 to 512
  std::array<std::int32_t, openr::kSensorCount> sensors{};  // um, um/s2, or how pressed

  std::int32_t of(openr::Sensor sensor) const { return sensors[openr::index(sensor)]; }
  template <int = 0>
  static constexpr auto fields() {
    return fieldList(field("joints", &RawSensors::joints), field("duty", &RawSensors::duty),
                     field("sensors", &RawSensors::sensors));
  }
};

// What a robot would tell whose body is so; saturated as its sensors are. What is not a number
// becomes the least number.
RawSensors rawOf(const SensorFrame& frame);
RawJoints rawOf(const JointAngles& angles);
// Where the joints go that are commanded so.
JointAngles anglesOf(const RawJoints& raw);

}  // namespace kelpie::host
