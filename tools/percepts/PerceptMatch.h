// SPDX-License-Identifier: Apache-2.0
// A match of agents in one process and one thread, without images and sockets: the world in time,
// and for each robot the loops of a real agent (robot/agent) with an Eye in the place of vision.
// Sensors every 32 ms, percepts every 1/30 s, two command vectors in flight, the world's radio and
// game controller. The same seed and the same behaviours give the same match, bit for bit. Where it
// differs from a match of processes: nothing passes the OPEN-R object, an order is there at once
// and not a step later, and a script in a long call of Python's own ends all of the match.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "robot/agent/loops/AgentLoops.h"
#include "tools/percepts/Eye.h"
#include "tools/sim/world/Server.h"
#include "tools/sim/world/World.h"

namespace kelpie::percepts {

struct MatchRobot {
  agent::AgentConfig config;
  std::string scripts;            // folder or zip of behaviours
  agent::LogSink* log = nullptr;  // must outlive the match
};

class PerceptMatch {
 public:
  // The robots in the order of the world's. `log`: of the truth; may be null. World and log must
  // outlive the match.
  PerceptMatch(sim::World& world, const std::vector<MatchRobot>& robots, std::uint64_t seed,
               LogWriter* log, sim::ServerHooks hooks = {});
  ~PerceptMatch();
  PerceptMatch(const PerceptMatch&) = delete;
  PerceptMatch& operator=(const PerceptMatch&) = delete;

  // Error: a script does not load.
  Status loaded() const;
  // Plays to the end. Error: what ended it before.
  Status run();

 private:
  struct Robot;

  Status moveTo(TimeUs now);
  void sense(std::size_t i);
  void look(TimeUs now);
  void talk(TimeUs now);
  void writeTruth(TimeUs now, bool image);
  void expose(TimeUs now);

  sim::World& world_;
  LogWriter* log_;
  sim::ServerHooks hooks_;
  agent::LogSink silent_;  // of robots without a log
  std::vector<std::unique_ptr<Robot>> robots_;
  Moment moment_;
  std::uint32_t images_ = 0;  // that were seen
};

}  // namespace kelpie::percepts
