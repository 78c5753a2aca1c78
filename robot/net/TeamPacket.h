// SPDX-License-Identifier: Apache-2.0
// A TeamMessage as the bytes of one UDP datagram, and back. All numbers are little-endian:
//
//   offset  bytes  content
//   0       4      "KELP"
//   4       1      version, 2
//   5       1      team: 0 red, 1 blue
//   6       2      bytes of the whole packet
//   8       8      sender's clock when the message was made, microseconds (int64)
//   16      4      CRC-32 (as zlib has it) of all bytes but these four
//   20      -      the TeamMessage as robot/core/fields/Encoding.h writes it
//
// decode() trusts nothing: whatever is wrong is one reason, and no part of the packet is used.
#pragma once

#include <optional>

#include "robot/core/types/FrameInput.h"
#include "robot/core/types/Radio.h"

namespace kelpie::net {

constexpr std::uint8_t kTeamPacketVersion = 2;
constexpr std::size_t kTeamPacketHeader = 20;

struct TeamPacket {
  TeamColour team = TeamColour::red;
  TimeUs made;  // by the sender's clock
  TeamMessage message;
};

// False, and no bytes, when the message does not fit: kMaxPacketBytes hold the fullest there is.
bool encode(const TeamPacket& packet, RadioPacket& bytes);

// The reason why it is refused; nothing when `packet` holds what was sent.
std::optional<RadioRefusal> decode(const RadioPacket& bytes, TeamPacket& packet);

}  // namespace kelpie::net
