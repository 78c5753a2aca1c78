// SPDX-License-Identifier: Apache-2.0
#include "tools/match/SkillField.h"

#include <fmt/core.h>

#include <cmath>
#include <memory>

namespace kelpie::match {
namespace {

const Angle kMaxPan = Angle::deg(88.0);
const Angle kHalfView = Angle::deg(28.0);  // of the image's width
const Angle kStandingTilt = Angle::deg(14.25);
constexpr double kFarthest = 450.0;  // cm: a goal farther away is not seen
constexpr double kPositionSd = 5.0;  // cm
const Angle kHeadingSd = Angle::deg(2.0);

// One robot in an ideal world.
struct Seat {
  FrameInput input;
  Percepts percepts;
  WorldModel world;
};

double lengthOf(Point2<Robot> p) { return std::hypot(p.x, p.y); }

bool inView(const Seat& seat, Angle heading) {
  return (heading - seat.input.sensors.joints[Joint::headPan]).abs() < kHalfView;
}

void believe(Seat& seat, const Pose2& pose, Point2<Field> ball) {
  seat.world.pose = pose;
  seat.world.positionSd = kPositionSd;
  seat.world.headingSd = kHeadingSd;
  BallEstimate& estimate = seat.world.ball;
  estimate.present = true;
  estimate.position = estimate.stoppingPoint = ball;
  estimate.relative = robotFromField(pose, ball);
  estimate.distance = lengthOf(estimate.relative);
  estimate.heading = bearing(estimate.relative);
}

void seeBall(Seat& seat) {
  const BallEstimate& ball = seat.world.ball;
  seat.percepts.ball.present = inView(seat, ball.heading);
  seat.percepts.ball.distance = ball.distance;
  seat.percepts.ball.heading = ball.heading;
}

// A goal with the whole of its mouth free.
void seeGoal(Seat& seat, const body::Landmark& goal, double width) {
  const Point2<Robot> middle = robotFromField(seat.world.pose, goal.position);
  LandmarkPercept seen;
  seen.kind = goal.kind;
  seen.distance = lengthOf(middle);
  seen.heading = bearing(middle);
  if (!inView(seat, seen.heading) || seen.distance > kFarthest) return;
  // Seen from the own half the left post of the far goal is that of the smaller x.
  const double half = goal.position.y > seat.world.pose.position.y ? 0.5 * width : -0.5 * width;
  const auto post = [&](double lateral) {
    return bearing(robotFromField(seat.world.pose, {goal.position.x + lateral, goal.position.y}));
  };
  seen.leftEdge = post(-half);
  seen.rightEdge = post(half);
  seat.percepts.landmarks.push_back(seen);
  GoalGap gap;
  gap.goal = goal.kind;
  gap.left = seen.leftEdge;
  gap.right = seen.rightEdge;
  seat.percepts.gaps.push_back(gap);
}

void place(Seat& seat, const agent::AgentConfig& config, const Pose2& pose, Point2<Field> ball) {
  seat.percepts = {};
  seat.input.frame += 1;
  seat.input.elapsed = kFrameSeconds;
  seat.input.time = TimeUs::fromSeconds(seat.input.frame * kFrameSeconds);
  seat.input.game.team = config.team;
  seat.input.game.player = config.player;
  seat.input.motion.ready = true;
  seat.input.stance.bodyTilt = kStandingTilt;
  believe(seat, pose, ball);
  const double pan = seat.world.ball.heading.rad();
  seat.input.sensors.joints[Joint::headPan] =
      Angle::rad(maths::clamp(pan, -kMaxPan.rad(), kMaxPan.rad()));
  seeBall(seat);
  for (const body::Landmark& landmark : body::landmarksFor(config.field, config.team))
    if (landmark.kind <= LandmarkKind::goalYellow) seeGoal(seat, landmark, config.field.goalWidth);
}

SkillStep stepOf(const Pose2& pose, const Command& command) {
  SkillStep step;
  step.place = pose.position;
  step.way =
      fieldFromRobot(pose, Point2<Robot>{-command.walk.left, command.walk.forward}) - pose.position;
  step.turn = Angle::rad(command.walk.turn);
  step.motion = command.motion;
  return step;
}

Pose2 poseAt(Point2<Field> place, const SkillQuestion& question) {
  const Point2<Field> way = question.ball - place;
  return {place, question.heading.value_or(Angle::rad(maths::atan2(way.y, way.x)))};
}

}  // namespace

Expected<std::vector<SkillStep>> skillField(const agent::AgentConfig& config,
                                            const SkillQuestion& question,
                                            behaviour::BehaviourState& behaviours) {
  const auto seat = std::make_unique<Seat>();
  std::vector<SkillStep> steps;
  const double first = 0.5 * question.step;
  for (double y = first; y < config.field.length; y += question.step) {
    for (double x = first; x < config.field.width; x += question.step) {
      const Pose2 pose = poseAt({x, y}, question);
      place(*seat, config, pose, question.ball);
      const Command command = behaviour::step(
          {seat->input, seat->percepts, seat->world, config.field}, config.behaviour, behaviours);
      if (command.fallback != Fallback::none)
        return Error{fmt::format("{} (robot at {:g}, {:g})", behaviours.lastError(), x, y)};
      steps.push_back(stepOf(pose, command));
    }
  }
  return steps;
}

}  // namespace kelpie::match
