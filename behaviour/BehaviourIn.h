// SPDX-License-Identifier: Apache-2.0
// What the behaviours see of one frame.
#pragma once

#include "robot/body/FieldDescription.h"
#include "robot/body/Infrared.h"
#include "robot/core/types/FrameInput.h"
#include "robot/core/types/Percepts.h"
#include "robot/core/types/WorldModel.h"

namespace kelpie::behaviour {

struct BehaviourIn {
  const FrameInput& input;
  const Percepts& percepts;
  const WorldModel& world;
  const body::FieldDescription& field;
  body::InfraredParams infrared{};  // of this robot
};

}  // namespace kelpie::behaviour
