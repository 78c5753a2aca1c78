// SPDX-License-Identifier: Apache-2.0
// The robot's own reader of a stick: checks every file that STICK.BIN lists and STICK.BIN itself,
// and fills the agent's configuration from it in place. A stick that is refused leaves the
// configuration as it was, but for a medium that reads well once and badly the second time: then it
// is half filled, and the fault says so. Needs 5 KB, which belong to the object and not on the
// stack.
#pragma once

#include "robot/stick/PieceReader.h"
#include "robot/stick/StickFormat.h"

namespace kelpie::stick {

class StickReader {
 public:
  explicit StickReader(StickFiles& files) : files_(files), reader_(files) {}

  // Reads every byte of every file that the robot uses.
  StickVerdict check();
  // check(), and only when that went well the configuration.
  StickVerdict load(agent::AgentConfig& config);
  // Of the last check() that went well.
  const StickFileList& list() const { return list_; }

 private:
  StickFault checkBinary();
  StickFault checkHeader() const;
  StickFault checkParts();
  StickFault readList();
  StickFault checkFile(const StickFileEntry& entry);
  StickFault readConfig(agent::AgentConfig& config);
  template <std::size_t... I>
  bool readMembers(Part part, agent::AgentConfig& config, std::index_sequence<I...> indices);
  bool readPart(Part part, agent::AgentConfig& config);
  bool readHeader();
  StickVerdict verdict(StickFault fault, const StickPath& file);

  StickFiles& files_;
  PieceReader reader_;
  StickHeader header_;
  StickFileList list_;
};

}  // namespace kelpie::stick
