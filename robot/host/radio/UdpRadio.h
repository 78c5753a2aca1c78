// SPDX-License-Identifier: Apache-2.0
// The team's radio as UDP datagrams between agents of this machine, in place of the simulated
// world's air: one port for each robot, basePort + 4 for each team + the player's number. Robots
// of both teams hear every packet, as over the air. Such a match does not replay: when a packet
// arrives is the machine's affair.
#pragma once

#include <cstdint>

#include "robot/core/Expected.h"
#include "robot/core/types/Radio.h"
#include "robot/host/radio/UdpSocket.h"
#include "robot/host/world/WorldProtocol.h"

namespace kelpie::host {

constexpr std::uint16_t kTeamPort = 20050;

class UdpRadio {
 public:
  // An error names the port when another agent has it.
  static Expected<UdpRadio> open(const AgentHello& self, std::uint16_t basePort = kTeamPort);

  // To all others; who is not there misses it.
  void send(const RadioPacket& packet);
  // The next packet that has arrived, without waiting; false when there is none. One that is longer
  // than any packet is given away cut short, for the receiver to count.
  bool receive(RadioPacket& packet);

 private:
  UdpRadio(UdpSocket socket, std::uint16_t ownPort, std::uint16_t basePort);

  UdpSocket socket_;
  std::uint16_t ownPort_ = 0;
  std::uint16_t basePort_ = 0;
};

}  // namespace kelpie::host
