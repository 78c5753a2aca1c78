// SPDX-License-Identifier: Apache-2.0
// What a game controller sends as bytes, and what a robot counts of it.
#pragma once

#include <array>
#include <cstdint>

#include "robot/core/FixedVector.h"
#include "robot/core/fields/Fields.h"
#include "robot/core/types/RefusalNames.h"

namespace kelpie {

// More than any packet that is used has, so that one that is too long is seen to be.
constexpr std::size_t kMaxControlBytes = 256;

struct ControlPacket {
  FixedVector<std::uint8_t, kMaxControlBytes> bytes;

  template <int = 0>
  static constexpr auto fields() {
    return fieldList(field("bytes", &ControlPacket::bytes));
  }
};

// Why a packet is not used; half to penaltyTime cost their field alone now and stand in old logs.
// The number is the place in ControlCounts::refused and in logs: append, never reorder.
enum class ControlRefusal : std::uint8_t {
  size,
  header,
  version,
  state,
  half,
  kickOffTeam,
  secondsLeft,
  dropInTeam,
  dropInTime,
  teamColour,
  score,
  penalty,
  penaltyTime,
  foreign,  // the robot's team number and colour are not those of one of the teams
};
constexpr std::size_t kControlRefusals = 14;
inline constexpr RefusalName<ControlRefusal> kControlRefusalNames[] = {
    {ControlRefusal::size, "size"},
    {ControlRefusal::header, "header"},
    {ControlRefusal::version, "version"},
    {ControlRefusal::state, "state"},
    {ControlRefusal::half, "half"},
    {ControlRefusal::kickOffTeam, "kickOffTeam"},
    {ControlRefusal::secondsLeft, "secondsLeft"},
    {ControlRefusal::dropInTeam, "dropInTeam"},
    {ControlRefusal::dropInTime, "dropInTime"},
    {ControlRefusal::teamColour, "teamColour"},
    {ControlRefusal::score, "score"},
    {ControlRefusal::penalty, "penalty"},
    {ControlRefusal::penaltyTime, "penaltyTime"},
    {ControlRefusal::foreign, "foreign"},
};
static_assert(areInOrder(kControlRefusalNames));

struct ControlCounts {
  std::uint32_t taken = 0;
  std::array<std::uint32_t, kControlRefusals> refused{};

  template <int = 0>
  static constexpr auto fields() {
    return fieldList(field("taken", &ControlCounts::taken),
                     field("refused", &ControlCounts::refused));
  }
};

}  // namespace kelpie
