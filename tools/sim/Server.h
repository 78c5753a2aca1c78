// SPDX-License-Identifier: Apache-2.0
// A World for agent processes: sends each what its robot senses and sees, waits for what it sends
// to the effectors, and lets time go on. Sensors every 32 ms, images every 1/30 s, in the order of
// time; no agent can be late, and none can be early.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "robot/core/LogWriter.h"
#include "robot/host/Connection.h"
#include "tools/sim/World.h"

namespace kelpie::sim {

struct Agent {
  host::Connection connection;
  host::AgentHello hello;
};

// Waits for `count` agents at an open socket and sorts them by team and number.
Expected<std::vector<Agent>> gatherAgents(host::Listener& listener, std::size_t count,
                                          double seconds);

// What else hears of a match while it is played; each may be empty.
struct ServerHooks {
  std::function<void(const MatchEvent&)> onEvent;
  std::function<void(TimeUs now)> beforeStep;  // may wait
  std::function<bool()> stopped;               // ends the match before its time
};

class Server {
 public:
  // `log` may be null. World and log must outlive the server.
  Server(World& world, std::vector<Agent>& agents, LogWriter* log, ServerHooks hooks = {});

  // Plays to the end. An agent that dies or talks nonsense ends the match with one line.
  Status run();

 private:
  Status sendStep(std::size_t robot, TimeUs now, bool sensors, bool image);
  Status takeReply(std::size_t robot);
  Status step(TimeUs now, bool sensors, bool image);
  Status moveTo(TimeUs now);
  void writeTruth(TimeUs now, bool image);
  void sayGoodbye(std::uint8_t reason);
  std::string nameOf(std::size_t robot) const;

  World& world_;
  std::vector<Agent>& agents_;
  LogWriter* log_;
  ServerHooks hooks_;
  std::vector<std::uint8_t> buffer_;
  std::unique_ptr<Image> image_;
};

}  // namespace kelpie::sim
