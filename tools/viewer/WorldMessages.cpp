// SPDX-License-Identifier: Apache-2.0
#include "tools/viewer/WorldMessages.h"

#include "foxglove/Log.pb.h"
#include "kelpie/Numbers.pb.h"
#include "tools/match/EventWords.h"
#include "tools/viewer/Beliefs.h"
#include "tools/viewer/BodyScene.h"
#include "tools/viewer/FieldScene.h"
#include "tools/viewer/Frames.h"
#include "tools/viewer/Shapes.h"

namespace kelpie::viewer {
namespace {

foxglove::SceneEntity nameOver(TimeUs time, const std::string& robot, TeamColour team) {
  constexpr double kOver = 32.0;  // cm
  constexpr double kSize = 0.1;   // m
  foxglove::SceneEntity scene = entity(time, trueFrame(robot), robot + " name");
  addText(scene, inBody(Point3<Robot>{0.0, 0.0, kOver}), kSize, robot, colourOf(team));
  return scene;
}

}  // namespace

void WorldMessages::field(TimeUs time, const body::FieldDescription& field) {
  if (fieldKnown_) return;
  fieldKnown_ = true;
  sink_.take("/field", at(time), fieldScene(at(time), field));
  sink_.take("/field/points", at(time), fieldPoints(at(time), field));
}

void WorldMessages::truth(const sim::TruthFrame& truth) {
  const TimeUs time = at(truth.time);
  robots(time, truth);
  ball(time, truth);
  kelpie::Score score;
  *score.mutable_timestamp() = stampOf(time);
  score.set_red(truth.redScore);
  score.set_blue(truth.blueScore);
  sink_.take("/score", time, score);
}

void WorldMessages::robots(TimeUs time, const sim::TruthFrame& truth) {
  foxglove::FrameTransforms tf;
  foxglove::PosesInFrame poses;
  foxglove::SceneUpdate scene;
  *poses.mutable_timestamp() = stampOf(time);
  poses.set_frame_id(kMapFrame);
  placed_.clear();
  for (const sim::RobotTruth& robot : truth.robots) {
    const std::string name = robotName(robot.team, robot.player);
    placed_.insert(name);
    *tf.add_transforms() = bodyTransform(time, trueFrame(name), robot.pose);
    *poses.add_poses() = poseOf(robot.pose);
    *scene.add_entities() = nameOver(time, name, robot.team);
    if (drawnElsewhere_.count(name) == 0)
      *scene.add_entities() = bodyScene(time, {trueFrame(name), name + " body", robot.team},
                                        standingJoints(robot.stance), robot.stance);
  }
  sink_.take("/tf", time, tf);
  sink_.take("/robots", time, scene);
  sink_.take("/robots/poses", time, poses);
}

void WorldMessages::ball(TimeUs time, const sim::TruthFrame& truth) {
  const bool there = distance(truth.ball, sim::kAwayBall) > 1.0;
  const auto middle = inMap(truth.ball, body::kBallRadius);
  foxglove::SceneUpdate update;
  foxglove::SceneEntity& scene = *update.add_entities();
  scene = entity(time, kMapFrame, "ball");
  if (there) addBall(scene, middle, metres(body::kBallRadius), ballColour());
  sink_.take("/ball/true", time, update);
  if (!there) return;
  foxglove::PoseInFrame pose = poseInMap(time, {truth.ball, {}});
  *pose.mutable_pose()->mutable_position() = middle;
  sink_.take("/ball/true/pose", time, pose);
}

void WorldMessages::event(const sim::MatchEvent& event) {
  foxglove::Log log;
  *log.mutable_timestamp() = stampOf(at(event.time));
  log.set_level(foxglove::Log::INFO);
  log.set_message(match::sentenceOf(event));
  log.set_name("referee");
  sink_.take("/referee", at(event.time), log);
}

}  // namespace kelpie::viewer
