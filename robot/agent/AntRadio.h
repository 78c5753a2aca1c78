// SPDX-License-Identifier: Apache-2.0
// The robot's own radio: hears the game controller at its port, and the team at another one, to
// which it broadcasts what this robot says. The loops get the same packets by it as by the host's
// sockets (robot/host/radio/UdpRadio, UdpControl).
#pragma once

#include "robot/agent/AntEndpoint.h"
#include "robot/agent/loops/Loops.h"
#include "robot/net/GameControlData.h"

namespace kelpie::agent {

struct RadioPorts {
  Port control = 0;  // 0: there is no radio
  Port team = 0;
};

// The league's port of the game controller; the team's is Kelpie's own, the same for both teams, so
// that a robot hears what is not meant for it as it would over the air.
constexpr RadioPorts kRobotPorts = {net::kGameControlPort, 20050};

class AntRadio {
 public:
  explicit AntRadio(const RadioPorts& ports);
  bool present() const { return ports_.control != 0; }

  // Opens both ports by calls that wait, so only where the robot may. All else is by messages.
  void begin(const OID& object, TimeUs now);
  // With each message of the sensors.
  void tick(TimeUs now);
  // What the last frame made for the team, if it made anything.
  void send(Loops& loops);

  // Answers of the network, at the entries of the same names.
  void controlHeard(void* answer, TimeUs now, Loops& loops);
  void teamHeard(void* answer, TimeUs now, Loops& loops);
  void teamSent(void* answer) { team_.sent(answer); }

 private:
  RadioPorts ports_;
  AntEndpoint control_;
  AntEndpoint team_;
  ControlPacket controlPacket_;
  RadioPacket heard_;
  RadioPacket said_;
};

}  // namespace kelpie::agent
