// SPDX-License-Identifier: Apache-2.0
#include "tools/learn/PhysicalWalker.h"

#include <cmath>
#include <stdexcept>

#include "robot/body/Ers7.h"
#include "robot/body/FieldDescription.h"

namespace kelpie::learn {
namespace {

constexpr int kStartMessages = 38;       // the ramp of 1 s and a moment of standing
constexpr double kWornCurrent = 4500.0;  // mA

std::unique_ptr<sim::PhysicalBodies> buildBodies(const sim::PhysicsParams& model,
                                                 std::uint64_t seed) {
  // Far from goals and beacons, and the room ends nowhere near.
  auto field = *body::fieldDescription("2006");
  field.sideFringe = field.endFringe = 1e5;
  sim::PhysicalStart start;
  start.pose = {{3000.0, 3000.0}, Angle::deg(90.0)};
  start.params = model;
  start.seed = seed;
  auto bodies = sim::PhysicalBodies::build(field, {start}, model, {});
  if (!bodies) throw std::runtime_error(bodies.error());
  (*bodies)->putBall({{2000.0, 2000.0}, {}});
  return std::move(*bodies);
}

}  // namespace

PhysicalWalker::PhysicalWalker(const sim::PhysicsParams& model,
                               const actuator::ActuatorParams& params, std::uint64_t seed)
    : bodies_(buildBodies(model, seed)), params_(&params) {
  for (int i = 0; i < kStartMessages; ++i) step({});
}

const MotionOutput& PhysicalWalker::step(const Command& command) {
  for (SensorFrame& sensors : input_.sensors) {
    if (!failed_) failed_ = !bodies_->tick();
    const sim::BodyFeeling feeling = bodies_->feel(0);
    sensors.joints = feeling.joints;
    sensors.duty = feeling.duty;
    sensors.acceleration = feeling.acceleration;
    sensors.paw = feeling.paw;
    sensors.chin = feeling.touch.chin;
  }
  input_.time.us += kTicksPerMessage * kTickUs;
  input_.batteryCurrent = worn_ ? kWornCurrent : 0.0;
  input_.command = command;
  output_ = actuator::step(input_, *params_, state_);
  send();
  if (!sent_) send();
  sent_ = true;
  return output_;
}

void PhysicalWalker::send() {
  host::AgentReply reply;
  reply.motorPower = true;
  reply.gains = (1U << kJointCount) - 1;
  if (output_.status.lowGain) reply.legGain = body::weakLegGain();
  host::EffectorVector vector;
  vector.ticks = kTicksPerMessage;
  vector.joints = reply.gains;
  for (std::size_t i = 0; i < kTicksPerMessage; ++i) vector.targets[i] = output_.joints[i].target;
  reply.vectors.push_back(vector);
  bodies_->command(0, reply);
}

bool PhysicalWalker::fallen() const {
  constexpr double kLies = 45.0;  // deg
  const sim::BodyPlace place = bodies_->place(0);
  return failed_ || std::fabs(place.lean.roll.deg()) > kLies ||
         std::fabs(place.stance.bodyTilt.deg()) > kLies;
}

}  // namespace kelpie::learn
