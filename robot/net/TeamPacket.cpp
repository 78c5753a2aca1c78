// SPDX-License-Identifier: Apache-2.0
#include "robot/net/TeamPacket.h"

#include <algorithm>
#include <array>
#include <cstring>

#include "robot/core/Checksum.h"
#include "robot/core/fields/Encoding.h"

namespace kelpie::net {
namespace {

constexpr std::array<std::uint8_t, 4> kMark = {'K', 'E', 'L', 'P'};
constexpr std::size_t kVersionAt = 4, kTeamAt = 5, kSizeAt = 6, kTimeAt = 8, kCheckAt = 16;

template <class T>
void put(RadioPacket& packet, std::size_t at, T value) {
  std::memcpy(packet.bytes.begin() + at, &value, sizeof value);
}

template <class T>
T get(const RadioPacket& packet, std::size_t at) {
  T value{};
  std::memcpy(&value, packet.bytes.begin() + at, sizeof value);
  return value;
}

// The check counts as zero while it is made.
std::uint32_t checkOf(RadioPacket packet) {
  put(packet, kCheckAt, std::uint32_t{0});
  return crc32(packet.bytes.begin(), packet.bytes.size());
}

// Bytes that say it as no sender does are wrong though they can be read: a heading of 1e300 rad is
// finite, and no angle any more when it is turned back by whole turns.
bool isAsSent(const TeamMessage& message, const RadioPacket& bytes) {
  RadioPacket again;
  again.bytes.resize(kTeamPacketHeader + encodedSize(message));
  encodeTo(message, again.bytes.begin() + kTeamPacketHeader);
  const auto* const begin = bytes.bytes.begin();
  return again.bytes.size() == bytes.bytes.size() &&
         std::equal(begin + kTeamPacketHeader, begin + bytes.bytes.size(),
                    again.bytes.begin() + kTeamPacketHeader);
}

}  // namespace

bool encode(const TeamPacket& packet, RadioPacket& bytes) {
  bytes.bytes.clear();
  const std::size_t size = kTeamPacketHeader + encodedSize(packet.message);
  if (size > kMaxPacketBytes) return false;
  bytes.bytes.resize(size);
  std::copy(kMark.begin(), kMark.end(), bytes.bytes.begin());
  put(bytes, kVersionAt, kTeamPacketVersion);
  put(bytes, kTeamAt, static_cast<std::uint8_t>(packet.team));
  put(bytes, kSizeAt, static_cast<std::uint16_t>(size));
  put(bytes, kTimeAt, packet.made.us);
  encodeTo(packet.message, bytes.bytes.begin() + kTeamPacketHeader);
  put(bytes, kCheckAt, checkOf(bytes));
  return true;
}

std::optional<RadioRefusal> decode(const RadioPacket& bytes, TeamPacket& packet) {
  const std::size_t size = bytes.bytes.size();
  if (size < kTeamPacketHeader || !std::equal(kMark.begin(), kMark.end(), bytes.bytes.begin()))
    return RadioRefusal::foreign;
  if (get<std::uint8_t>(bytes, kVersionAt) != kTeamPacketVersion) return RadioRefusal::version;
  if (get<std::uint16_t>(bytes, kSizeAt) != size) return RadioRefusal::size;
  if (get<std::uint32_t>(bytes, kCheckAt) != checkOf(bytes)) return RadioRefusal::check;
  const auto team = get<std::uint8_t>(bytes, kTeamAt);
  packet.made.us = get<std::int64_t>(bytes, kTimeAt);
  const std::uint8_t* const body = bytes.bytes.begin() + kTeamPacketHeader;
  const bool whole = team <= static_cast<std::uint8_t>(TeamColour::blue) &&
                     kelpie::decode(body, size - kTeamPacketHeader, packet.message);
  if (!whole || !verify(packet.message, nullptr) || !isAsSent(packet.message, bytes))
    return RadioRefusal::broken;
  packet.team = static_cast<TeamColour>(team);
  return std::nullopt;
}

}  // namespace kelpie::net
