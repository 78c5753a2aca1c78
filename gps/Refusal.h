// SPDX-License-Identifier: Apache-2.0
// Why the localiser did not use something; what is not used is counted by these reasons. So is, as
// landmarkMoved, what it does not use as it is.
#pragma once

#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <tuple>

#include "robot/core/types/RefusalNames.h"
#include "robot/core/types/WorldModel.h"

namespace kelpie::gps {

// The number is the place in GpsCounts::refused and in recorded logs: append, never reorder.
enum class Refusal : std::uint8_t {
  odometryNotFinite,  // or farther than a robot can walk in one frame, or without a sound time
  landmarkNotFinite,  // or without a positive variance
  landmarkUnknown,    // the field has no such landmark
  headingUncertain,
  goalTooClose,
  goalTooOblique,   // seen from next to its own goal line
  nothingMeasured,  // in older logs: neither distance nor heading passed its gate
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
  tiltUnlikely,   // far from what is known of the camera's tilt
  landmarkMoved,  // it is used where it seems to stand, which is not where the map has it
};

// In the order of the numbers.
inline constexpr RefusalName<Refusal> kRefusalNames[] = {
    {Refusal::odometryNotFinite, "odometryNotFinite"},
    {Refusal::landmarkNotFinite, "landmarkNotFinite"},
    {Refusal::landmarkUnknown, "landmarkUnknown"},
    {Refusal::headingUncertain, "headingUncertain"},
    {Refusal::goalTooClose, "goalTooClose"},
    {Refusal::goalTooOblique, "goalTooOblique"},
    {Refusal::nothingMeasured, "nothingMeasured"},
    {Refusal::seedOffField, "seedOffField"},
    {Refusal::modeNotFinite, "modeNotFinite"},
    {Refusal::ballNotFinite, "ballNotFinite"},
    {Refusal::ballOutsideGate, "ballOutsideGate"},
    {Refusal::messageBroken, "messageBroken"},
    {Refusal::messageRepeated, "messageRepeated"},
    {Refusal::opponentNotFinite, "opponentNotFinite"},
    {Refusal::opponentUncertain, "opponentUncertain"},
    {Refusal::linesMatchNothing, "linesMatchNothing"},
    {Refusal::effortNotFinite, "effortNotFinite"},
    {Refusal::pinkNotFinite, "pinkNotFinite"},
    {Refusal::pinkPoseUnsure, "pinkPoseUnsure"},
    {Refusal::pinkOffWall, "pinkOffWall"},
    {Refusal::pinkElevation, "pinkElevation"},
    {Refusal::pinkNearBeacon, "pinkNearBeacon"},
    {Refusal::pinkMapFull, "pinkMapFull"},
    {Refusal::tiltUnlikely, "tiltUnlikely"},
    {Refusal::landmarkMoved, "landmarkMoved"},
};
constexpr std::size_t kRefusalCount = std::size(kRefusalNames);

static_assert(areInOrder(kRefusalNames), "each refusal has its name, in the order of the numbers");
static_assert(kRefusalCount <= std::tuple_size_v<decltype(GpsCounts::refused)>,
              "a log keeps a count of each");

// Stays at the highest number rather than begin again at 0.
inline void count(Refusal reason, GpsCounts& counts) {
  std::uint16_t& number = counts.refused[static_cast<std::size_t>(reason)];
  if (number < std::numeric_limits<std::uint16_t>::max()) ++number;
}

}  // namespace kelpie::gps
