// SPDX-License-Identifier: Apache-2.0
#include "robot/host/radio/UdpRadio.h"

#include <utility>

namespace kelpie::host {
namespace {

constexpr std::uint16_t kRobots = 8;
constexpr const char* kThisMachine = "127.0.0.1";

}  // namespace

UdpRadio::UdpRadio(UdpSocket socket, std::uint16_t ownPort, std::uint16_t basePort)
    : socket_(std::move(socket)), ownPort_(ownPort), basePort_(basePort) {}

Expected<UdpRadio> UdpRadio::open(const AgentHello& self, std::uint16_t basePort) {
  const int own = basePort + 4 * static_cast<int>(self.team) + self.player;
  const auto port = static_cast<std::uint16_t>(own);
  auto socket = UdpSocket::open({port, false, false});
  if (!socket) return Error{"radio: " + socket.error()};
  return UdpRadio(std::move(*socket), port, basePort);
}

void UdpRadio::send(const RadioPacket& packet) {
  for (std::uint16_t i = 1; i <= kRobots; ++i) {
    const auto port = static_cast<std::uint16_t>(basePort_ + i);
    if (port == ownPort_) continue;
    (void)socket_.send(kThisMachine, port, packet.bytes.begin(), packet.bytes.size());
  }
}

bool UdpRadio::receive(RadioPacket& packet) {
  packet.bytes.resize(kMaxPacketBytes);
  const auto size = socket_.receive(packet.bytes.begin(), kMaxPacketBytes);
  packet.bytes.resize(size.value_or(0));
  return size.has_value();
}

}  // namespace kelpie::host
