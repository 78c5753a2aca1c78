// SPDX-License-Identifier: Apache-2.0
// What a robot believes, in the frame map, whichever team it is of.
#pragma once

#include <string>

#include "foxglove/Frames.pb.h"
#include "foxglove/Scene.pb.h"
#include "kelpie/Numbers.pb.h"
#include "robot/core/types/FrameOutput.h"
#include "tools/viewer/Frames.h"

namespace kelpie::viewer {

// Of whom, and when.
struct Believer {
  TimeUs time;
  std::string robot;
  TeamColour team = TeamColour::red;
  MapFrame map;
};

foxglove::PoseInFrame poseInMap(TimeUs time, const Pose2& onMap);
foxglove::PosesInFrame modePoses(const Believer& who, const WorldModel& world);

// Each mode as an ellipse of one standard deviation with an arrow, the fainter the less it weighs;
// then the opponents' ellipses and the cells of the obstacle map.
foxglove::SceneUpdate hypothesesScene(const Believer& who, const WorldModel& world);

// The ball with its ellipse, where it rolls in a second and where it will lie. Without a ball the
// entity is empty, so that the one before is not drawn on.
foxglove::SceneUpdate ballScene(const Believer& who, const BallEstimate& ball);
foxglove::PoseInFrame ballPose(const Believer& who, const BallEstimate& ball);

// In the frame of the body that is believed.
foxglove::PointCloud linePoints(const Believer& who, const Percepts& percepts);

kelpie::RobotNumbers numbersOf(TimeUs time, const GameState& game, const FrameOutput& output);

}  // namespace kelpie::viewer
