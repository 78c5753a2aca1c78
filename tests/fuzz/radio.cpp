// SPDX-License-Identifier: Apache-2.0
// A packet of the team: the bytes as they come, and once more with a right size and checksum, which
// nobody finds by trying. What is taken is in range and may be sent on.
#include <memory>

#include "robot/core/Checksum.h"
#include "robot/core/fields/FieldCheck.h"
#include "robot/net/TeamPacket.h"
#include "tests/fuzz/Input.h"

namespace {

using namespace kelpie;
using fuzz::require;

void put(RadioPacket& packet, std::size_t at, std::uint32_t value, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i)
    packet.bytes[at + i] = static_cast<std::uint8_t>(value >> (8 * i));
}

RadioPacket sealed(RadioPacket packet) {
  const std::size_t size = packet.bytes.size();
  if (size < net::kTeamPacketHeader) return packet;
  put(packet, 6, static_cast<std::uint32_t>(size), 2);
  put(packet, 16, 0, 4);
  put(packet, 16, crc32(packet.bytes.begin(), size), 4);
  return packet;
}

void check(const RadioPacket& bytes) {
  const auto packet = std::make_unique<net::TeamPacket>();
  if (net::decode(bytes, *packet)) return;
  std::string why;
  require(verify(packet->message, &why), "what is taken is in range: " + why);
  RadioPacket again;
  require(net::encode(*packet, again), "what is taken may be sent on");
  const auto back = std::make_unique<net::TeamPacket>();
  require(!net::decode(again, *back), "what is sent on is taken");
  require(!firstDifference(packet->message, back->message, &why), "and says the same: " + why);
  require(packet->team == back->team && packet->made.us == back->made.us, "of the same robot");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  RadioPacket packet;
  packet.bytes.resize(std::min(size, packet.bytes.kCapacity));
  std::copy_n(data, packet.bytes.size(), packet.bytes.begin());
  check(packet);
  check(sealed(packet));
  return 0;
}
