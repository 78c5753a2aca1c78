// SPDX-License-Identifier: Apache-2.0
// A robot on its feet that looks somewhere, other robots around it, and an eye that errs in nothing
// or as it does.
#pragma once

#include "robot/body/Camera.h"
#include "robot/body/Ers7.h"
#include "tools/percepts/Eye.h"

namespace kelpie::percepts {

inline EyeNoise withoutErrors() {
  constexpr RecallByShare kAll{1.0, 1.0, 1.0, 1.0, 1.0, 1.0};
  EyeNoise noise;
  BallErrors& ball = noise.ball;
  ball.near = ball.far = kAll;
  ball.pixel = ball.share = ball.turningShare = ball.partShare = ball.bias = ball.farBias = 0.0;
  noise.beacon = {kAll, 500.0, 0.0, 0.0, 0.0};
  noise.goal.recall = kAll;
  noise.goal.nearRecall = 1.0;
  noise.goal.pixel = noise.goal.share = noise.goal.hiddenShare = 0.0;
  RobotErrors& robot = noise.robot;
  robot.recall = robot.tooManyRecall = robot.nearRecall = 1.0;
  robot.redFew = robot.blueFew = 0.1;
  robot.redMany = robot.blueMany = 0.2;
  robot.share = robot.bias = robot.across = 0.0;
  noise.obstacle = {1.0, 0.0};
  noise.line.pixel = noise.edgeRms = 0.0;
  noise.falseOnes = {0.0, 0.0};
  return noise;
}

class Looking {
 public:
  // The robot that looks stands there; its head is panned and tilted so far.
  explicit Looking(const Pose2& pose, Angle pan = {}, Angle tilt = Angle::deg(-20.0)) {
    add(pose);
    moment.robots[0].joints[Joint::headPan] = pan;
    moment.robots[0].joints[Joint::neckTilt] = tilt;
    moment.ball = {-500.0, -500.0};
  }
  void add(const Pose2& pose, TeamColour team = TeamColour::blue) {
    sim::BodyPlace place;
    place.pose = pose;
    place.stance.shoulderHeight = 12.0;
    moment.robots.push_back(place);
    moment.teams.push_back(team);
  }
  Percepts see(const EyeNoise& noise = withoutErrors(), std::uint64_t seed = 1) {
    FrameInput input;
    input.sensors.joints = moment.robots[0].joints;
    input.stance = moment.robots[0].stance;
    Eye eye(field, 0, seed, noise);
    eye.show(moment);
    Percepts percepts;
    eye.see(input, body::step(input, {}), percepts);
    return percepts;
  }
  Point2<Robot> truly(Point2<Field> place) const {
    return robotFromField(moment.robots[0].pose, place);
  }

  Moment moment;
  body::FieldDescription field = *body::fieldDescription("2006");
};

}  // namespace kelpie::percepts
