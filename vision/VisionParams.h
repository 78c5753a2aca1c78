// SPDX-License-Identifier: Apache-2.0
// Vision's tunables by object. Where a number is not explained here, README.md gives its source.
#pragma once

#include "robot/body/FieldDescription.h"
#include "robot/core/fields/Fields.h"
#include "vision/ball/BallFinderParams.h"
#include "vision/beacon/BeaconFinderParams.h"
#include "vision/edge/FieldEdgeParams.h"
#include "vision/goal/GoalFinderParams.h"
#include "vision/light/LightParams.h"
#include "vision/line/LinePointParams.h"
#include "vision/pink/PinkFinderParams.h"
#include "vision/robot/ObstacleParams.h"
#include "vision/robot/RobotFinderParams.h"

namespace kelpie::vision {

struct VisionParams {
  // The agent's (AgentConfig::field), so it is not in the list.
  body::FieldDescription field = *body::fieldDescription("2006");
  BallFinderParams ball;
  BeaconFinderParams beacon;
  GoalFinderParams goal;
  HorizonScanParams scan;
  FieldEdgeParams fieldEdge;
  LinePointParams line;
  RobotFinderParams robot;
  PinkFinderParams pink;
  ObstacleParams obstacle;
  LightParams light;

  template <int = 0>
  static constexpr auto fields() {
    using kelpie::field;
    return fieldList(field("ball", &VisionParams::ball), field("beacon", &VisionParams::beacon),
                     field("goal", &VisionParams::goal), field("scan", &VisionParams::scan),
                     field("fieldEdge", &VisionParams::fieldEdge),
                     field("line", &VisionParams::line), field("robot", &VisionParams::robot),
                     field("pink", &VisionParams::pink), field("obstacle", &VisionParams::obstacle),
                     field("light", &VisionParams::light));
  }
};

}  // namespace kelpie::vision
