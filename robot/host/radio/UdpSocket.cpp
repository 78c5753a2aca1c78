// SPDX-License-Identifier: Apache-2.0
#include "robot/host/radio/UdpSocket.h"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <utility>

namespace kelpie::host {
namespace {

void allow(int descriptor, int option) {
  const int yes = 1;
  (void)setsockopt(descriptor, SOL_SOCKET, option, &yes, sizeof yes);
}

sockaddr_in addressOf(std::uint32_t host, std::uint16_t port) {
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(port);
  address.sin_addr.s_addr = host;
  return address;
}

}  // namespace

UdpSocket::UdpSocket(UdpSocket&& other) noexcept
    : descriptor_(std::exchange(other.descriptor_, -1)) {}

UdpSocket::~UdpSocket() {
  if (descriptor_ >= 0) close(descriptor_);
}

Expected<UdpSocket> UdpSocket::open(const UdpAt& at) {
  const int descriptor = socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0);
  if (descriptor < 0) return Error{std::string("no socket: ") + std::strerror(errno)};
  UdpSocket made(descriptor);
  allow(descriptor, SO_BROADCAST);
  if (at.shared) allow(descriptor, SO_REUSEADDR);
  const auto address = addressOf(htonl(at.everywhere ? INADDR_ANY : INADDR_LOOPBACK), at.port);
  if (bind(descriptor, reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0)
    return Error{"port " + std::to_string(at.port) + ": " + std::strerror(errno)};
  return made;
}

bool UdpSocket::send(const std::string& address, std::uint16_t port, const std::uint8_t* bytes,
                     std::size_t size) {
  const auto to = addressOf(inet_addr(address.c_str()), port);
  const ssize_t sent =
      sendto(descriptor_, bytes, size, 0, reinterpret_cast<const sockaddr*>(&to), sizeof to);
  return sent == static_cast<ssize_t>(size);
}

std::optional<std::size_t> UdpSocket::receive(std::uint8_t* bytes, std::size_t max) {
  for (;;) {
    const ssize_t size = recv(descriptor_, bytes, max, 0);
    // Who is not there answers a send with an error, which tells nothing of what comes.
    if (size < 0 && errno == ECONNREFUSED) continue;
    if (size < 0) return std::nullopt;
    return static_cast<std::size_t>(size);
  }
}

bool isAddress(const std::string& text) {
  in_addr ignored{};
  return inet_pton(AF_INET, text.c_str(), &ignored) == 1;
}

}  // namespace kelpie::host
