// SPDX-License-Identifier: Apache-2.0
// Why the localiser did not use something; what is not used is counted by these reasons.
#pragma once

#include <cstdint>

#include "robot/core/WorldModel.h"

namespace kelpie::gps {

// The index into GpsCounts::refused.
enum class Refusal : std::uint8_t {
  odometryNotFinite,  // or farther than a robot can walk in one frame, or without a sound time
  landmarkNotFinite,  // or without a positive variance
  landmarkUnknown,    // the field has no such landmark
  headingUncertain,
  goalTooClose,
  goalTooOblique,   // seen from next to its own goal line
  nothingMeasured,  // neither distance nor heading passed its gate
  seedOffField,     // no place on the field explains the first landmark
  modeNotFinite,    // a hypothesis was removed
  ballNotFinite,
  ballOutsideGate,  // waits for a second sighting like it
  messageBroken,    // something in a mate's message cannot be
  messageRepeated,  // or it is older than the last
  opponentNotFinite,
  opponentUncertain,  // vague, or far from the field
  linesMatchNothing,  // near a likely mode
  effortNotFinite,    // or not what a mean of duties can be
  pinkNotFinite,
  pinkPoseUnsure,  // the robot knows its own place too badly to map what it sees
  pinkOffWall,     // its direction meets no wall
  pinkElevation,   // too low or too high for the wall
  pinkNearBeacon,
  pinkMapFull,
};
constexpr std::size_t kRefusalCount = 23;

inline void count(Refusal reason, GpsCounts& counts) {
  ++counts.refused[static_cast<std::size_t>(reason)];
}

}  // namespace kelpie::gps
