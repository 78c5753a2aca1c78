// SPDX-License-Identifier: Apache-2.0
// Marks where stages begin and end for the instruction counter (toolchain/icount): a system call
// with a number that nobody else asks for, which the counter sees and the kernel refuses. About 60
// instructions each, counted with the stage.
#pragma once

#include "robot/agent/loops/StageObserver.h"

namespace kelpie::target {

class StageMarkers : public agent::StageObserver {
 public:
  StageMarkers();  // marks the end of the program's own start

  void begin(agent::Stage stage) override;
  void end(agent::Stage stage) override;
  void beginFrame() override;
  void endFrame() override;
};

}  // namespace kelpie::target
