// SPDX-License-Identifier: Apache-2.0
// All that the camera loop makes of one FrameInput, stage by stage.
#pragma once

#include "robot/core/Time.h"
#include "robot/core/types/Command.h"
#include "robot/core/types/Percepts.h"
#include "robot/core/types/WorldModel.h"

namespace kelpie {

struct FrameOutput {
  std::uint32_t frame = 0;
  TimeUs time;
  BodyState body;
  Percepts percepts;
  WorldModel world;
  Command command;

  template <int = 0>
  static constexpr auto fields() {
    return fieldList(field("frame", &FrameOutput::frame), field("time", &FrameOutput::time, "us"),
                     field("body", &FrameOutput::body), field("percepts", &FrameOutput::percepts),
                     field("world", &FrameOutput::world), field("command", &FrameOutput::command));
  }
};

}  // namespace kelpie
