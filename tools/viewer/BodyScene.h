// SPDX-License-Identifier: Apache-2.0
// A robot's body as boxes and bars where its joints put them, in the frame of its body
// (Frames.h). The places of the joints are those of robot/body; how thick a part is drawn is said
// here. A body that leans to a side is drawn upright.
#pragma once

#include <string>

#include "foxglove/Scene.pb.h"
#include "robot/core/types/FrameInput.h"
#include "robot/core/types/Joints.h"
#include "robot/core/types/Motion.h"

namespace kelpie::viewer {

struct BodyLook {
  std::string frame;
  std::string id;
  TeamColour team = TeamColour::red;
};

foxglove::SceneEntity bodyScene(TimeUs time, const BodyLook& look, const JointAngles& joints,
                                const Stance& stance);

// Joints of a robot that stands on straight legs below its shoulders and looks ahead: of one whose
// joints nobody recorded.
JointAngles standingJoints(const Stance& stance);

}  // namespace kelpie::viewer
