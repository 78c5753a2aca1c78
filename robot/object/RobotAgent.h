// SPDX-License-Identifier: Apache-2.0
// The OPEN-R object of a robot with all that it is made of. Once it has started it reads its memory
// stick, a block with each message of the sensors, so that its lights go on telling how far it is:
// reading, then starting Python. With a good stick it plays as the stick says. A refused one does
// not end the object, which could tell nobody why: it starts all the same, says the reason in one
// line of the system's log, stays lying and blinks the reason's number (FaultLoops). What the
// behaviours print, and what goes wrong in them, goes to that log, too.
#pragma once

#include "robot/agent/Agent.h"
#include "robot/object/Robot.h"
#include "robot/stick/StdioFiles.h"
#include "robot/stick/StickReader.h"

namespace kelpie::object {

// What must be there before the object that keeps a reference to it; the reader's 5 KB are here and
// not on the stack.
struct RobotParts {
  explicit RobotParts(const char* stickRoot) : root(stickRoot), files(stickRoot), reader(files) {}

  const char* root;
  LateLoops loops;
  stick::StdioFiles files;
  stick::StickReader reader;
};

class RobotAgent : private RobotParts, public agent::Agent {
 public:
  // The root of the stick's files: "/MS" on the robot (openr.md section 6), else a folder.
  explicit RobotAgent(const char* stickRoot, const agent::RadioPorts& ports = {})
      : RobotParts(stickRoot), agent::Agent(loops, ports) {}

 private:
  enum class Boot : std::uint8_t { begins, reads, startsPython, done };

  void beforeMotion() override;
  void takeStick();
  void frameDone() override;

  Boot boot_ = Boot::begins;
  std::uint32_t waits_ = 0;  // messages, until what the lights tell has been seen
  std::unique_ptr<agent::AgentConfig> config_;  // until the loops have their own
};

}  // namespace kelpie::object
