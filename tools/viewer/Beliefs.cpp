// SPDX-License-Identifier: Apache-2.0
#include "tools/viewer/Beliefs.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "tools/viewer/Points.h"
#include "tools/viewer/Shapes.h"

namespace kelpie::viewer {
namespace {

using foxglove::LinePrimitive;

constexpr double kTurn = 2.0 * maths::kPi;
constexpr int kCorners = 24;
constexpr double kAbove = 1.0;       // cm, so that the carpet hides nothing
constexpr double kThin = 0.01;       // m
constexpr double kObstacleFull = 8;  // points of a cell that is drawn without transparency

// A symmetric 2 x 2 matrix's root times points of the unit circle (its Cholesky factor: any root
// draws the same ellipse). The same for a field that is turned by half a turn.
std::vector<foxglove::Vector3> ellipse(const Point2<Field>& middle, double xx, double xy,
                                       double yy) {
  const double a = std::sqrt(std::max(xx, 0.0));
  const double b = a > 0.0 ? xy / a : 0.0;
  const double c = std::sqrt(std::max(yy - b * b, 0.0));
  std::vector<foxglove::Vector3> corners;
  for (int i = 0; i < kCorners; ++i) {
    const double turn = kTurn * i / kCorners;
    const Point2<Field> out{a * std::cos(turn), b * std::cos(turn) + c * std::sin(turn)};
    corners.push_back(inMap(middle + out, kAbove));
  }
  return corners;
}

foxglove::Color fainter(foxglove::Color colour, double share) {
  colour.set_a(std::clamp(share, 0.0, 1.0));
  return colour;
}

void addMode(foxglove::SceneEntity& to, const Believer& who, const PoseMode& mode) {
  constexpr double kFaintest = 0.15;
  const Pose2 pose = who.map.pose(mode.pose);
  const auto& c = mode.covariance;
  const foxglove::Color ink = fainter(colourOf(who.team), kFaintest + mode.weight);
  addLines(to, LinePrimitive::LINE_LOOP, kThin, ellipse(pose.position, c[0], c[1], c[4]), ink);
  foxglove::Pose arrow = poseOf(pose);
  arrow.mutable_position()->set_z(metres(kAbove));
  addArrow(to, arrow, 0.2, ink);
}

foxglove::SceneEntity opponents(const Believer& who, const WorldModel& world) {
  foxglove::SceneEntity scene = entity(who.time, kMapFrame, who.robot + " opponents");
  const foxglove::Color ink =
      colourOf(who.team == TeamColour::red ? TeamColour::blue : TeamColour::red);
  for (const OpponentEstimate& opponent : world.opponents) {
    const Point2<Field> middle = who.map.point(opponent.position);
    const auto& c = opponent.covariance;
    addLines(scene, LinePrimitive::LINE_LOOP, kThin, ellipse(middle, c[0], c[1], c[3]), ink);
  }
  return scene;
}

foxglove::SceneEntity obstacles(const Believer& who, const WorldModel& world) {
  constexpr double kSide = 10.0;  // cm
  foxglove::SceneEntity scene = entity(who.time, kMapFrame, who.robot + " obstacles");
  for (const ObstacleCell& cell : world.obstacles)
    addBox(scene, poseAt(inMap(who.map.point(cell.position), 0.5 * kAbove)),
           inMap({kSide, kSide}, kAbove),
           fainter(colour(1.0, 0.3, 1.0), (cell.own + cell.heard) / kObstacleFull));
  return scene;
}

void addBallTo(foxglove::SceneEntity& scene, const Believer& who, const BallEstimate& ball) {
  constexpr double kStill = 5.0;  // cm/s
  const Point2<Field> place = who.map.point(ball.position);
  const auto& c = ball.fieldCovariance;
  addBall(scene, inMap(place, body::kBallRadius), metres(body::kBallRadius),
          fainter(ballColour(), 0.6));
  addLines(scene, LinePrimitive::LINE_LOOP, kThin, ellipse(place, c[0], c[1], c[3]), ballColour());
  const Point2<Field> velocity = who.map.direction(ball.velocity);
  if (velocity.norm() < kStill) return;
  const Angle way = Angle::rad(std::atan2(velocity.y, velocity.x));
  foxglove::Pose arrow = poseOf({place, way});
  arrow.mutable_position()->set_z(metres(body::kBallRadius));
  addArrow(scene, arrow, metres(velocity.norm()), ballColour());
  addLines(scene, LinePrimitive::LINE_STRIP, kThin,
           {inMap(place, kAbove), inMap(who.map.point(ball.stoppingPoint), kAbove)}, ballColour());
}

}  // namespace

foxglove::PoseInFrame poseInMap(TimeUs time, const Pose2& onMap) {
  foxglove::PoseInFrame pose;
  *pose.mutable_timestamp() = stampOf(time);
  pose.set_frame_id(kMapFrame);
  *pose.mutable_pose() = poseOf(onMap);
  return pose;
}

foxglove::PosesInFrame modePoses(const Believer& who, const WorldModel& world) {
  foxglove::PosesInFrame poses;
  *poses.mutable_timestamp() = stampOf(who.time);
  poses.set_frame_id(kMapFrame);
  for (const PoseMode& mode : world.modes) *poses.add_poses() = poseOf(who.map.pose(mode.pose));
  return poses;
}

foxglove::SceneUpdate hypothesesScene(const Believer& who, const WorldModel& world) {
  foxglove::SceneUpdate update;
  foxglove::SceneEntity& modes = *update.add_entities();
  modes = entity(who.time, kMapFrame, who.robot + " hypotheses");
  for (const PoseMode& mode : world.modes) addMode(modes, who, mode);
  *update.add_entities() = opponents(who, world);
  *update.add_entities() = obstacles(who, world);
  return update;
}

foxglove::SceneUpdate ballScene(const Believer& who, const BallEstimate& ball) {
  foxglove::SceneUpdate update;
  foxglove::SceneEntity& scene = *update.add_entities();
  scene = entity(who.time, kMapFrame, who.robot + " ball");
  if (ball.present) addBallTo(scene, who, ball);
  return update;
}

foxglove::PoseInFrame ballPose(const Believer& who, const BallEstimate& ball) {
  const Point2<Field> v = who.map.direction(ball.velocity);
  const Angle way = Angle::rad(v.norm() > 0.0 ? std::atan2(v.y, v.x) : 0.0);
  foxglove::PoseInFrame pose = poseInMap(who.time, {who.map.point(ball.position), way});
  pose.mutable_pose()->mutable_position()->set_z(metres(body::kBallRadius));
  return pose;
}

foxglove::PointCloud linePoints(const Believer& who, const Percepts& percepts) {
  Points points(who.time, believedFrame(who.robot));
  for (const LinePoint& p : percepts.linePoints) points.add(inBody(p.position), colourOf(p.kind));
  return points.cloud();
}

kelpie::RobotNumbers numbersOf(TimeUs time, const GameState& game, const FrameOutput& output) {
  constexpr std::array<const char*, 5> kStates = {"initial", "ready", "set", "playing", "finished"};
  const BallEstimate& ball = output.world.ball;
  const WalkRequest& walk = output.command.walk;
  const TeamNote& note = output.command.team;
  kelpie::RobotNumbers numbers;
  *numbers.mutable_timestamp() = stampOf(time);
  numbers.set_state(kStates[static_cast<std::size_t>(game.state)]);
  numbers.set_penalised(game.penalised);
  numbers.set_role(kRoleNames[static_cast<std::size_t>(note.role)]);
  if (note.timeToBall < kNoTime) numbers.set_time_to_ball_s(note.timeToBall);
  if (ball.present) {
    numbers.set_ball_distance_m(metres(ball.distance));
    numbers.set_ball_speed_m_s(metres(ball.velocity.norm()));
    numbers.set_ball_unseen_s(ball.secondsSinceSeen);
  }
  numbers.set_position_sd_m(metres(output.world.positionSd));
  numbers.set_heading_sd_deg(output.world.headingSd.deg());
  numbers.set_stuck(output.world.stuck);
  numbers.set_walk_forward_m_s(metres(walk.forward));
  numbers.set_walk_left_m_s(metres(walk.left));
  numbers.set_walk_turn_deg_s(walk.turn * 180.0 / maths::kPi);
  return numbers;
}

}  // namespace kelpie::viewer
