// SPDX-License-Identifier: Apache-2.0
#include "tools/viewer/RobotMessages.h"

#include <algorithm>

#include "foxglove/Log.pb.h"
#include "tools/viewer/BodyScene.h"
#include "tools/viewer/CameraMessages.h"

namespace kelpie::viewer {
namespace {

// A log that keeps no sensors of a frame has zeros in their place, which no real body has.
bool sensed(const FrameInput& input) {
  const auto& angles = input.sensors.joints.angle;
  return std::any_of(angles.begin(), angles.end(), [](Angle a) { return a.rad() != 0.0; });
}

bool cameraKnown(const CameraPose& camera) {
  return std::any_of(camera.axes.begin(), camera.axes.end(), [](double a) { return a != 0.0; });
}

}  // namespace

RobotMessages::RobotMessages(TeamColour team, std::uint8_t player,
                             const body::FieldDescription& field, TimeUs start, MessageSink& sink)
    : robot_(robotName(team, player)),
      team_(team),
      map_(field, team),
      start_(start),
      sink_(sink),
      bodyFrame_(believedFrame(robot_)) {}

void RobotMessages::send(const std::string& topic, const google::protobuf::Message& message) {
  sink_.take("/" + robot_ + "/" + topic, now_, message);
}

void RobotMessages::frame(const FrameInput& input, const std::vector<std::uint8_t>& jpeg,
                          const FrameOutput& output) {
  now_ = {start_.us + input.time.us};
  transforms(output);
  camera(jpeg, output);
  if (sensed(input)) body(input);
  beliefs(output);
  send("numbers", numbersOf(now_, input.game, output));
  reasons(input, output);
}

void RobotMessages::transforms(const FrameOutput& output) {
  foxglove::FrameTransforms tf;
  *tf.add_transforms() = bodyTransform(now_, believedFrame(robot_), map_.pose(output.world.pose));
  if (cameraKnown(output.body.camera))
    *tf.add_transforms() = cameraTransform(now_, robot_, output.body.camera);
  sink_.take("/tf", now_, tf);
}

void RobotMessages::camera(const std::vector<std::uint8_t>& jpeg, const FrameOutput& output) {
  if (jpeg.empty()) return;
  send("camera", cameraImage(now_, robot_, jpeg));
  send("camera/calibration", calibrationOf(now_, robot_, output.body.camera.lens));
  send("camera/annotations", annotationsOf(now_, output.percepts));
}

void RobotMessages::body(const FrameInput& input) {
  foxglove::SceneUpdate update;
  *update.add_entities() =
      bodyScene(now_, {bodyFrame_, robot_ + " body", team_}, input.sensors.joints, input.stance);
  send("robot", update);
}

void RobotMessages::beliefs(const FrameOutput& output) {
  const Believer who{now_, robot_, team_, map_};
  const WorldModel& world = output.world;
  send("pose", poseInMap(now_, map_.pose(world.pose)));
  if (!world.modes.empty()) {
    send("poses", modePoses(who, world));
    send("hypotheses", hypothesesScene(who, world));
    send("line_points", linePoints(who, output.percepts));
  }
  send("ball", ballScene(who, world.ball));
  if (world.ball.present) send("ball/pose", ballPose(who, world.ball));
}

void RobotMessages::reasons(const FrameInput& input, const FrameOutput& output) {
  const std::string words = changes_.take(input.drive.present, output.command);
  if (words.empty()) return;
  foxglove::Log log;
  *log.mutable_timestamp() = stampOf(now_);
  log.set_level(output.command.fallback == Fallback::none ? foxglove::Log::INFO
                                                          : foxglove::Log::ERROR);
  log.set_message(words);
  log.set_name(robot_);
  send("log", log);
}

}  // namespace kelpie::viewer
