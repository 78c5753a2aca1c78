// SPDX-License-Identifier: Apache-2.0
// Bodies without masses: feet that stand carry their robot (RobotModel.h), robots are kept apart as
// pairs of discs, the ball is a disc (BallContact.h). Fifty times as fast as the physical ones; no
// robot falls, and a ball brakes none but who presses it against another robot.
#pragma once

#include <vector>

#include "tools/sim/bodies/Bodies.h"
#include "tools/sim/bodies/RobotModel.h"
#include "tools/sim/kicks/FastKicks.h"
#include "tools/sim/world/BallContact.h"

namespace kelpie::sim {

// What a motor's controller gives: duty for a following error.
constexpr double kDutyPerRad = 2.5;  // 1/rad

// What the accelerometer of a robot that does not move tells, but for its noise: gravity in the
// body as it really leans, and the sensor's own bias. Forward, left, up.
std::array<double, 3> accelerationAtRest(const Stance& stance, const BodyFaults& faults);

class KinematicBodies : public Bodies {
 public:
  // `seed`: of where kicks send the ball.
  KinematicBodies(const BallParams& ball, const body::FieldDescription& field,
                  std::uint64_t seed = 0)
      : ballParams_(ball), field_(field), obstacles_(obstaclesOf(field)), kicks_(ball, seed) {}

  void add(RobotModel robot) { robots_.push_back(std::move(robot)); }
  RobotModel& robot(std::size_t i) { return robots_[i]; }

  std::size_t count() const override { return robots_.size(); }
  void command(std::size_t robot, const host::AgentReply& reply) override {
    robots_[robot].command(reply);
  }
  std::uint32_t takeVectorsDone(std::size_t robot) override {
    return robots_[robot].queue().takeVectorsDone();
  }
  std::size_t vectorsWaiting(std::size_t robot) override {
    return robots_[robot].queue().vectorsWaiting();
  }
  Status tick() override;
  BodyPlace place(std::size_t robot) const override { return robots_[robot].place(); }
  BodyFeeling feel(std::size_t robot) override;
  std::array<bool, kLegCount> onGround(std::size_t robot) const override {
    return robots_[robot].onGround();
  }
  Ball ball() const override { return ball_; }
  std::optional<std::size_t> ballToucher() const override { return ballToucher_; }
  void putBall(const Ball& ball) override {
    for (std::size_t i = 0; i < robots_.size(); ++i) kicks_.drop(i);
    ball_ = ball;
  }
  void carry(std::size_t robot, const Pose2& pose) override {
    kicks_.drop(robot);
    robots_[robot].carry(pose);
  }
  void hold(std::size_t robot, double share) override { robots_[robot].hold(share); }
  void shove(std::size_t robot, Point2<Field> way, Angle turn) override {
    robots_[robot].push(way);
    robots_[robot].twist(turn);
  }
  void lift(std::size_t robot, double height) override { robots_[robot].lift(height); }
  void touch(std::size_t robot, const Touch& touch) override { robots_[robot].touch(touch); }
  Status setObstacles(const std::vector<Obstacle>& obstacles) override {
    obstacles_ = obstacles;
    return Done{};
  }

 private:
  void tickBallAmongRobots();
  void holdUp(const Ball& at);
  void keepApart();
  void separate(std::size_t one, std::size_t other);
  // The one half of that way, the other as far back.
  void pushApart(std::size_t one, std::size_t other, Point2<Field> way);
  bool chinTouched(std::size_t robot, const BodySphere& head) const;
  bool pushes(std::size_t robot, const BodySphere& part) const;
  std::array<bool, kLegCount> pawsPressed(std::size_t robot,
                                          const std::array<BodySphere, 9>& parts) const;

  BallParams ballParams_;
  body::FieldDescription field_;
  std::vector<Obstacle> obstacles_;
  std::vector<RobotModel> robots_;
  Ball ball_;
  std::optional<std::size_t> ballToucher_;
  std::optional<std::size_t> bouncedOff_;  // who touched it after a kick, in the same tick
  FastKicks kicks_;
};

}  // namespace kelpie::sim
