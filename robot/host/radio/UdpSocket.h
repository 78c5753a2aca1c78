// SPDX-License-Identifier: Apache-2.0
// Datagrams at one port of this machine. Nothing ever waits.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include "robot/core/Expected.h"

namespace kelpie::host {

struct UdpAt {
  std::uint16_t port = 0;  // 0: any that is free
  bool everywhere = true;  // hears whoever reaches this machine, broadcasts too; or itself alone
  bool shared = false;     // others of this machine may hear the same broadcasts
};

class UdpSocket {
 public:
  // An error names the port.
  static Expected<UdpSocket> open(const UdpAt& at);
  ~UdpSocket();
  UdpSocket(UdpSocket&& other) noexcept;
  UdpSocket& operator=(UdpSocket&&) = delete;
  UdpSocket(const UdpSocket&) = delete;
  UdpSocket& operator=(const UdpSocket&) = delete;

  // To an address such as 127.0.0.1, a broadcast one included; false when it cannot be sent.
  bool send(const std::string& address, std::uint16_t port, const std::uint8_t* bytes,
            std::size_t size);
  // The next datagram that has arrived, cut to `max` bytes: how long it is so; nothing when there
  // is none.
  std::optional<std::size_t> receive(std::uint8_t* bytes, std::size_t max);

 private:
  explicit UdpSocket(int descriptor) : descriptor_(descriptor) {}

  int descriptor_ = -1;
};

// "192.168.0.255" and not a name.
bool isAddress(const std::string& text);

}  // namespace kelpie::host
