// SPDX-License-Identifier: Apache-2.0
// A physical robot with its actuator on carpet without an end, as cheap as can be: commands
// in, what the actuator tells and the true way out. Two command vectors are in flight, as on the
// robot. It begins standing. An opponent may stand before it, which does always the same.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "actuator/Actuator.h"
#include "robot/core/Random.h"
#include "tools/sim/physics/PhysicalBodies.h"

namespace kelpie::learn {

// Stands so far ahead, its face to the robot, on a model like the robot's own.
struct Opponent {
  double ahead = 35.0;  // cm between the neck bases
  Command command;
};

class PhysicalWalker {
 public:
  PhysicalWalker(const sim::PhysicsParams& model, const actuator::ActuatorParams& params,
                 std::uint64_t seed, const std::optional<Opponent>& opponent = std::nullopt);
  // A copy goes on from the same instant, with other parameters if need be.
  PhysicalWalker(const PhysicalWalker& other, const actuator::ActuatorParams& params);

  // 32 ms. After a fault of the physics nothing moves any more and failed() is true.
  const MotionOutput& step(const Command& command);
  const MotionOutput& output() const { return drives_[0].output; }

  sim::BodyPlace place() const { return bodies_->place(0); }
  Pose2 pose() const { return place().pose; }
  bool fallen() const;
  bool failed() const { return failed_; }
  // Called after every tick of 8 ms, by this walker and by none of its copies.
  void watch(std::function<void()> tick) { watcher_ = std::move(tick); }
  void spareLegs() { worn_ = true; }  // the battery gives so much that the actuator takes weak legs
  void rest(Rest why) { rest_ = why; }
  sim::PhysicalBodies& bodies() { return *bodies_; }
  const actuator::ActuatorState& state() const { return drives_[0].state; }

 private:
  // The actuator of one robot.
  struct Drive {
    actuator::ActuatorState state;
    MotionInput input;
    MotionOutput output;
    bool sent = false;
  };
  void feel(std::size_t tick);
  void act(std::size_t robot, const Command& command);
  void send(std::size_t robot);

  std::unique_ptr<sim::PhysicalBodies> bodies_;
  const actuator::ActuatorParams* params_;  // must live as long
  std::vector<Drive> drives_;
  Command opponent_;
  Random random_;                         // of the sensors
  std::vector<sim::Obstacle> obstacles_;  // none
  bool failed_ = false;
  bool worn_ = false;
  Rest rest_ = Rest::none;  // of the robot, not of its opponent
  std::function<void()> watcher_;
};

}  // namespace kelpie::learn
