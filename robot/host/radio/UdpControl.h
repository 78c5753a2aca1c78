// SPDX-License-Identifier: Apache-2.0
// Where a game controller is heard: its datagrams at a port of this machine, from anywhere. A match
// that hears one does not replay as a whole, since when a packet arrives is the machine's affair;
// each robot's log does.
#pragma once

#include "robot/core/types/ControlPacket.h"
#include "robot/host/radio/UdpSocket.h"

namespace kelpie::host {

class UdpControl {
 public:
  // `shared`: other robots of this machine hear the same port, and all of them its broadcasts. An
  // error names the port.
  static Expected<UdpControl> open(std::uint16_t port, bool shared) {
    auto socket = UdpSocket::open({port, true, shared});
    if (!socket) return Error{"game controller: " + socket.error()};
    return UdpControl(std::move(*socket));
  }

  // The next packet that has arrived, without waiting; false when there is none. One that is longer
  // than any packet is given away cut short, for the receiver to count.
  bool receive(ControlPacket& packet) {
    packet.bytes.resize(kMaxControlBytes);
    const auto size = socket_.receive(packet.bytes.begin(), kMaxControlBytes);
    packet.bytes.resize(size.value_or(0));
    return size.has_value();
  }

 private:
  explicit UdpControl(UdpSocket socket) : socket_(std::move(socket)) {}

  UdpSocket socket_;
};

}  // namespace kelpie::host
