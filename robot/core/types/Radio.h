// SPDX-License-Identifier: Apache-2.0
// What goes over the radio, as bytes, and what a robot counts of it.
#pragma once

#include <array>
#include <cstdint>

#include "robot/core/FixedVector.h"
#include "robot/core/fields/Fields.h"

namespace kelpie {

// Fits into one Ethernet frame with the headers of IP and UDP.
constexpr std::size_t kMaxPacketBytes = 1400;
constexpr std::size_t kMaxPackets = 8;  // that arrive between two messages of the sensors

struct RadioPacket {
  FixedVector<std::uint8_t, kMaxPacketBytes> bytes;

  template <int = 0>
  static constexpr auto fields() {
    return fieldList(field("bytes", &RadioPacket::bytes));
  }
};
using RadioPackets = FixedVector<RadioPacket, kMaxPackets>;

// Why a packet changed nothing. The number is the place in RadioCounts::refused and in recorded
// logs: append, never reorder.
enum class RadioRefusal : std::uint8_t {
  foreign,    // no packet of Kelpie's at all
  version,    // of another version of Kelpie's
  size,       // shorter or longer than it says
  check,      // its CRC-32 is wrong
  otherTeam,  // meant for the opponents
  echo,       // from this robot's own number
  broken,     // its message cannot be decoded, or something in it is out of range
  doubled,    // its number, or a later one, was heard before
  late,       // it was under way for longer than anybody waits
};
constexpr std::size_t kRadioRefusals = 9;

// All stay at the highest number rather than begin again at 0.
struct RadioCounts {
  std::uint16_t heard = 0;
  std::uint16_t lost = 0;  // by the gaps in the numbers of what was heard
  std::array<std::uint16_t, kRadioRefusals> refused{};

  template <int = 0>
  static constexpr auto fields() {
    return fieldList(field("heard", &RadioCounts::heard), field("lost", &RadioCounts::lost),
                     field("refused", &RadioCounts::refused));
  }
};

}  // namespace kelpie
