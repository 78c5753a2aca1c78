// SPDX-License-Identifier: Apache-2.0
// Robots and ball on the carpet as bodies with masses, servos and contacts, in ticks of 8 ms:
// steps of 2 ms, of 1 ms while the ball is within reach of a robot's head and paws (a blow lasts
// one or two steps of 2 ms). The same commands give the same bits.
#pragma once

#include <optional>
#include <vector>

#include "tools/sim/physics/PhysicalRobot.h"
#include "tools/sim/world/Ball.h"

namespace kelpie::sim {

class Physics {
 public:
  static Expected<Physics> build(const body::FieldDescription& field, const RobotsPhysics& robots,
                                 const PhysicsParams& world);

  std::size_t robotCount() const { return robots_.size(); }
  const PhysicalRobot& robot(std::size_t i) const { return robots_[i]; }
  const PhysicsParams& params(std::size_t i) const { return params_[i]; }
  Engine& engine() { return engine_; }
  const Engine& engine() const { return engine_; }

  void putRobot(std::size_t i, const Pose2& pose, const JointAngles& joints);
  void putBall(const Ball& ball);
  Ball ball() const;
  // What stands on the field, all of it. Error: more than the model has room for.
  Status setObstacles(const std::vector<Obstacle>& obstacles);
  double ballHeight() const;  // cm, of its centre
  // The robot that gave the ball the greatest push of the last tick.
  std::optional<std::size_t> ballToucher() const;

  // One tick, or in one line what went wrong.
  Status tick();

 private:
  Physics(Engine engine, const body::FieldDescription& field, RobotsPhysics params,
          const PhysicsParams& world);
  bool ballNearRobot() const;
  void rollBall();
  void feelPushes(double seconds);

  Engine engine_;
  body::FieldDescription field_;
  RobotsPhysics params_;
  PhysicsParams world_;
  std::vector<PhysicalRobot> robots_;
  std::vector<double> pushes_;  // N s that the ball got of each robot in this tick
  int ballBody_ = 0;
  int ballQpos_ = 0;
  int ballDof_ = 0;
};

}  // namespace kelpie::sim
