// SPDX-License-Identifier: Apache-2.0
// What the OPEN-R object of a robot is made of: the configuration, and the loops, which are made
// when the object is initialised and not by a static constructor: what goes wrong there can be told
// to nobody (openr.md 5.1).
#pragma once

#include <memory>

#include "robot/agent/AgentConfig.h"
#include "robot/agent/AgentLoops.h"

namespace kelpie::object {

// Everything as in the code: standard parameters, no calibration of one robot. 185 KB.
std::unique_ptr<agent::AgentConfig> makeConfig();

// The loops of a robot: on it nobody listens.
struct SilentSink {
  agent::LogSink silent;
};
class RobotLoops : private SilentSink, public agent::AgentLoops {
 public:
  explicit RobotLoops(const agent::AgentConfig& config) : AgentLoops(config, {}, silent) {}
};

// Room for the loops, 0.7 MB, part of the object and not of the heap. Who is given loops() before
// make() may keep the reference, and must not use it.
class LateLoops {
 public:
  LateLoops() = default;
  LateLoops(const LateLoops&) = delete;
  LateLoops& operator=(const LateLoops&) = delete;
  ~LateLoops();

  agent::Loops& loops() { return room_.loops; }
  // Once; later calls do nothing.
  void make(const agent::AgentConfig& config);

 private:
  union Room {
    Room() {}   // NOLINT(modernize-use-equals-default): the loops are made later
    ~Room() {}  // NOLINT(modernize-use-equals-default): LateLoops ends them
    RobotLoops loops;
  };

  Room room_;
  bool made_ = false;
};

}  // namespace kelpie::object
