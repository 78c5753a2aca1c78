// SPDX-License-Identifier: Apache-2.0
#include "robot/host/UdpRadio.h"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <string>
#include <utility>

namespace kelpie::host {
namespace {

constexpr std::uint16_t kRobots = 8;

sockaddr_in addressOf(std::uint16_t port) {
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(port);
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  return address;
}

}  // namespace

UdpRadio::UdpRadio(int descriptor, std::uint16_t ownPort, std::uint16_t basePort)
    : descriptor_(descriptor), ownPort_(ownPort), basePort_(basePort) {}

UdpRadio::UdpRadio(UdpRadio&& other) noexcept
    : descriptor_(std::exchange(other.descriptor_, -1)),
      ownPort_(other.ownPort_),
      basePort_(other.basePort_) {}

UdpRadio::~UdpRadio() {
  if (descriptor_ >= 0) close(descriptor_);
}

Expected<UdpRadio> UdpRadio::open(const AgentHello& self, std::uint16_t basePort) {
  const int own = basePort + 4 * static_cast<int>(self.team) + self.player;
  const auto port = static_cast<std::uint16_t>(own);
  const int descriptor = socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0);
  if (descriptor < 0) return Error{std::string("radio: no socket: ") + std::strerror(errno)};
  UdpRadio radio(descriptor, port, basePort);
  const sockaddr_in address = addressOf(port);
  if (bind(descriptor, reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0)
    return Error{"radio: port " + std::to_string(own) + ": " + std::strerror(errno)};
  return radio;
}

void UdpRadio::send(const RadioPacket& packet) {
  for (std::uint16_t i = 1; i <= kRobots; ++i) {
    const auto port = static_cast<std::uint16_t>(basePort_ + i);
    if (port == ownPort_) continue;
    const sockaddr_in to = addressOf(port);
    (void)sendto(descriptor_, packet.bytes.begin(), packet.bytes.size(), 0,
                 reinterpret_cast<const sockaddr*>(&to), sizeof to);
  }
}

bool UdpRadio::receive(RadioPacket& packet) {
  packet.bytes.resize(kMaxPacketBytes);
  for (;;) {
    const ssize_t size = recv(descriptor_, packet.bytes.begin(), kMaxPacketBytes, 0);
    // A mate that is not there answers a send with an error, which tells nothing of what comes.
    if (size < 0 && errno == ECONNREFUSED) continue;
    packet.bytes.resize(size < 0 ? 0 : static_cast<std::size_t>(size));
    return size >= 0;
  }
}

}  // namespace kelpie::host
