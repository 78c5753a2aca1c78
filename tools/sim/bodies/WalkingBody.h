// SPDX-License-Identifier: Apache-2.0
// A robot with its actuator in the simulated world, without pixels: commands in, odometry and the
// true way out. Two command vectors are in flight, as on the robot.
#pragma once

#include <cmath>
#include <memory>

#include "actuator/Actuator.h"
#include "robot/body/Ers7.h"
#include "robot/body/FieldDescription.h"
#include "robot/host/primitives/Orders.h"
#include "tools/sim/bodies/FastActuator.h"
#include "tools/sim/world/World.h"

namespace kelpie::sim {

enum class BodyKind : std::uint8_t { fast, physical };

class WalkingBody {
 public:
  static constexpr int kStartMessages = 62;  // 2 s: ramp and standing

  // In the middle of the field, looking up it.
  explicit WalkingBody(std::uint64_t seed, const actuator::ActuatorParams& params = {},
                       BodyKind kind = BodyKind::fast, const PhysicsParams& physics = {},
                       const GroundParams& ground = RobotParams{}.ground)
      : params_(params) {
    const auto field = *body::fieldDescription("2006");
    Setup setup;
    setup.players.push_back({TeamColour::red, 1, {{180.0, 200.0}, Angle::deg(90.0)}});
    setup.ball = {20.0, 20.0};
    WorldParams world;
    world.fast = kind == BodyKind::fast;
    // Parameters that are a kinematic body's already stay as they are.
    if (kind == BodyKind::fast && params_.physical) makeFast(world.robot, params_);
    world.physics = physics;
    world.robot.ground = ground;
    world_ = std::make_unique<World>(world, field, setup, seed);
    for (int i = 0; i < kStartMessages; ++i) step({});
  }

  // 32 ms; what the actuator reported at its end.
  MotionOutput step(const Command& command) {
    for (int tick = 0; tick < kTicksPerMessage; ++tick) world_->tick();
    MotionInput input;
    input.time = world_->time();
    input.sensors = world_->sensors(0);
    input.batteryCurrent = worn_ ? kWornCurrent : world_->batteryCurrent(0);
    input.command = command;
    const MotionOutput output = actuator::step(input, params_, state_);
    send(output);
    if (!started_) send(output);
    started_ = true;
    return output;
  }
  // From now on the battery gives so much current that the agent spares the legs.
  void wearOut() { worn_ = true; }

  // As no walking robot does; nothing in a kinematic world falls.
  bool fallen() {
    constexpr double kLies = 45.0;  // deg
    const BodyPlace place = world_->bodies().place(0);
    return std::fabs(place.lean.roll.deg()) > kLies ||
           std::fabs(place.stance.bodyTilt.deg()) > kLies;
  }
  Pose2 pose() const { return world_->truth(world_->time()).robots[0].pose; }
  World& world() { return *world_; }

 private:
  static constexpr double kWornCurrent = 4500.0;  // mA

  void send(const MotionOutput& output) {
    const double gain = body::meanOf({output.status.lowGain, output.status.legGain});
    world_->bodies().command(0, host::ordersOf(output.joints, gain));
  }

  std::unique_ptr<World> world_;
  actuator::ActuatorParams params_;
  actuator::ActuatorState state_;
  bool started_ = false;
  bool worn_ = false;
};

}  // namespace kelpie::sim
