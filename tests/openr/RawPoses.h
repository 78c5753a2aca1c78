// SPDX-License-Identifier: Apache-2.0
// What a real robot's sensor vector would hold in seven poses, put together by hand from
// robot/openr/Contract.h, and what a person would say who sees the robot so. No line of the world
// or of its stand-in for the robot has a part in the numbers.
#pragma once

#include <OPENR/ODataFormats.h>

#include <array>
#include <string>

#include "robot/agent/joints/Senses.h"
#include "robot/core/types/Motion.h"

namespace kelpie::openr {

enum class RawPose : std::uint8_t {
  stands,
  onNose,
  onTail,
  onLeftSide,
  onRightSide,
  onBack,
  carried,
};
constexpr std::size_t kRawPoseCount = 7;

struct RawRow {
  const char* locator;
  std::array<slongword, kRawPoseCount> value;  // in the order of RawPose
};

// Joints in microradians, then sensors.
constexpr std::size_t kRawRowCount = 33;
extern const std::array<RawRow, kRawRowCount> kRawRows;
extern const std::array<const char*, kRawPoseCount> kSeen;  // what a person says of each

slongword rawValue(RawPose pose, const char* locator);

// The pose through the agent's OPEN-R side, with every tick alike.
SensorFrame sensedBy(const agent::Senses& senses, RawPose pose);

// The same words for what the agent makes of its sensors, by its kinematics and its own feeling of
// a fall.
std::string seenIn(const SensorFrame& frame);

}  // namespace kelpie::openr
