// SPDX-License-Identifier: Apache-2.0
// The actuator in the simulated body, without pixels: how far the robot really walks for what its
// odometry says, and how far and straight the ball goes from each place in the kick's zone.
#include <cmath>
#include <memory>

#include "actuator/Actuator.h"
#include "robot/body/FieldDescription.h"
#include "tools/cli/experiments/Experiment.h"
#include "tools/sim/World.h"

namespace kelpie::cli {
namespace {

constexpr int kStartMessages = 62;  // 2 s: ramp and standing
constexpr int kWalkMessages = 90;
constexpr int kStopMessages = 30;

// One robot in the middle of the field with its actuator, two command vectors in flight.
class Body {
 public:
  explicit Body(std::uint64_t seed) {
    const auto field = *body::fieldDescription("2006");
    sim::Setup setup;
    setup.players.push_back({TeamColour::red, 1, {{180.0, 200.0}, Angle::deg(90.0)}});
    setup.ball = {20.0, 20.0};
    world_ = std::make_unique<sim::World>(sim::WorldParams{}, field, setup, seed);
    for (int i = 0; i < kStartMessages; ++i) step({});
  }
  // 32 ms; the odometry of that step.
  Odometry step(const Command& command) {
    for (int tick = 0; tick < kTicksPerMessage; ++tick) world_->tick();
    MotionInput input;
    input.time = world_->time();
    input.sensors = world_->sensors(0);
    input.command = command;
    const MotionOutput output = actuator::step(input, params_, state_);
    send(output);
    if (!started_) send(output);
    started_ = true;
    return output.odometry;
  }
  Pose2 pose() const { return world_->truth({}).robots[0].pose; }
  sim::Ball& ball() { return world_->ball(); }

 private:
  void send(const MotionOutput& output) {
    host::AgentReply reply;
    reply.motorPower = true;
    reply.gains = (1U << kJointCount) - 1;
    host::EffectorVector vector;
    vector.ticks = kTicksPerMessage;
    vector.joints = reply.gains;
    for (std::size_t i = 0; i < kTicksPerMessage; ++i) vector.targets[i] = output.joints[i].target;
    reply.vectors.push_back(vector);
    world_->robot(0).command(reply);
  }

  std::unique_ptr<sim::World> world_;
  actuator::ActuatorParams params_;
  actuator::ActuatorState state_;
  bool started_ = false;
};

struct Way {
  double forward = 0.0;
  double left = 0.0;
  double turn = 0.0;  // rad
};

// True way over the way that the odometry reports.
Way walkRatio(const WalkRequest& request, std::uint64_t seed) {
  Body body(seed);
  Way said;
  Way walked;
  Pose2 last = body.pose();
  for (int i = 0; i < kWalkMessages + kStopMessages; ++i) {
    Command command;
    if (i < kWalkMessages) command.walk = request;
    const Odometry odometry = body.step(command);
    said = {said.forward + odometry.forward, said.left + odometry.left,
            said.turn + odometry.turn.rad()};
    const Point2<Robot> moved = robotFromField(last, body.pose().position);
    walked = {walked.forward + moved.y, walked.left - moved.x,
              walked.turn + (body.pose().heading - last.heading).rad()};
    last = body.pose();
  }
  return {walked.forward / said.forward, walked.left / said.left, walked.turn / said.turn};
}

// Where the ball comes to rest, in the robot frame at the kick, less where it lay.
Point2<Robot> kicked(Point2<Robot> from, std::uint64_t seed) {
  Body body(seed);
  const Pose2 pose = body.pose();
  body.ball() = {fieldFromRobot(pose, from), {0.0, 0.0}};
  Command command;
  command.motion = MotionKind::kickForward;
  for (int i = 0; i < 150; ++i) body.step(i < 20 ? command : Command{});
  return robotFromField(pose, body.ball().position) - from;
}

}  // namespace

Expected<Json> walkAndKick(const ExperimentOptions& options) {
  double least = 1e9;
  double mean = 0.0;
  double aside = 0.0;
  int kicks = 0;
  for (const double ahead : {6.0, 7.0, 8.0, 9.0, 10.0})
    for (const double x : {-4.0, -2.0, 0.0, 2.0, 4.0}) {
      const Point2<Robot> way = kicked({x, ahead}, options.seed);
      least = std::fmin(least, way.y);
      mean += way.y;
      aside = std::fmax(aside, std::fabs(bearing(way).deg()));
      ++kicks;
    }
  return Json{{"experiment", "walk-and-kick"},
              {"seed", options.seed},
              {"forward_ratio", walkRatio({20.0, 0.0, 0.0}, options.seed).forward},
              {"back_ratio", walkRatio({-15.0, 0.0, 0.0}, options.seed).forward},
              {"side_ratio", walkRatio({0.0, 12.0, 0.0}, options.seed).left},
              {"turn_ratio", walkRatio({0.0, 0.0, 1.2}, options.seed).turn},
              {"kicks", kicks},
              {"kick_mean_cm", mean / kicks},
              {"kick_least_cm", least},
              {"kick_aside_deg", aside}};
}

}  // namespace kelpie::cli
