// SPDX-License-Identifier: Apache-2.0
#include "tools/learn/walk/PhysicalWalker.h"

#include <cmath>
#include <stdexcept>

#include "robot/body/Ers7.h"
#include "robot/body/FieldDescription.h"
#include "robot/host/primitives/Orders.h"
#include "tools/sim/bodies/Sensors.h"

namespace kelpie::learn {
namespace {

constexpr int kStartMessages = 38;  // the ramp of 1 s and a moment of standing
constexpr double kDistanceNoise = 0.03;
constexpr double kWornCurrent = 4500.0;  // mA

std::unique_ptr<sim::PhysicalBodies> buildBodies(const sim::PhysicsParams& model,
                                                 std::uint64_t seed,
                                                 const std::optional<Opponent>& opponent) {
  // Far from goals and beacons, and the room ends nowhere near.
  auto field = *body::fieldDescription("2006");
  field.sideFringe = field.endFringe = 1e5;
  sim::PhysicalStart start;
  start.pose = {{3000.0, 3000.0}, Angle::deg(90.0)};
  start.params = model;
  start.seed = seed;
  std::vector<sim::PhysicalStart> starts{start};
  if (opponent) {
    start.pose = {{3000.0, 3000.0 + opponent->ahead}, Angle::deg(-90.0)};
    starts.push_back(start);
  }
  auto bodies = sim::PhysicalBodies::build(field, starts, model, {});
  if (!bodies) throw std::runtime_error(bodies.error());
  (*bodies)->putBall({{2000.0, 2000.0}, {}});
  return std::move(*bodies);
}

}  // namespace

PhysicalWalker::PhysicalWalker(const sim::PhysicsParams& model,
                               const actuator::ActuatorParams& params, std::uint64_t seed,
                               const std::optional<Opponent>& opponent)
    : bodies_(buildBodies(model, seed, opponent)),
      params_(&params),
      drives_(bodies_->count()),
      random_(seed) {
  for (int i = 0; i < kStartMessages; ++i) step({});
  if (opponent) opponent_ = opponent->command;
}

PhysicalWalker::PhysicalWalker(const PhysicalWalker& other, const actuator::ActuatorParams& params)
    : bodies_(std::make_unique<sim::PhysicalBodies>(*other.bodies_)),
      params_(&params),
      drives_(other.drives_),
      opponent_(other.opponent_),
      random_(other.random_),
      failed_(other.failed_),
      worn_(other.worn_),
      rest_(other.rest_) {}

const MotionOutput& PhysicalWalker::step(const Command& command) {
  for (std::size_t tick = 0; tick < kTicksPerMessage; ++tick) {
    if (!failed_) failed_ = !bodies_->tick();
    feel(tick);
    if (watcher_) watcher_();
  }
  for (std::size_t i = 0; i < drives_.size(); ++i) act(i, i == 0 ? command : opponent_);
  return output();
}

void PhysicalWalker::feel(std::size_t tick) {
  std::vector<sim::BodyPlace> places;
  for (std::size_t i = 0; i < drives_.size(); ++i) places.push_back(bodies_->place(i));
  for (std::size_t i = 0; i < drives_.size(); ++i) {
    SensorFrame& sensors = drives_[i].input.sensors[tick];
    const sim::BodyFeeling feeling = bodies_->feel(i);
    sensors.joints = feeling.joints;
    sensors.duty = feeling.duty;
    sensors.acceleration = feeling.acceleration;
    sensors.paw = feeling.paw;
    sensors.chin = feeling.touch.chin;
    sensors.chestDistance =
        sim::chestDistance({bodies_->ball(), obstacles_, places, i}, kDistanceNoise, random_);
  }
}

void PhysicalWalker::act(std::size_t robot, const Command& command) {
  Drive& drive = drives_[robot];
  drive.input.time.us += kTicksPerMessage * kTickUs;
  drive.input.batteryCurrent = worn_ ? kWornCurrent : 0.0;
  drive.input.command = command;
  drive.input.rest = robot == 0 ? rest_ : Rest::none;
  drive.output = actuator::step(drive.input, *params_, drive.state);
  send(robot);
  if (!drive.sent) send(robot);
  drive.sent = true;
}

void PhysicalWalker::send(std::size_t robot) {
  const MotionOutput& output = drives_[robot].output;
  const double gain = body::meanOf({output.status.lowGain, output.status.legGain});
  bodies_->command(robot, host::ordersOf(output.joints, gain));
}

bool PhysicalWalker::fallen() const {
  constexpr double kLies = 45.0;  // deg
  const sim::BodyPlace place = bodies_->place(0);
  return failed_ || std::fabs(place.lean.roll.deg()) > kLies ||
         std::fabs(place.stance.bodyTilt.deg()) > kLies;
}

}  // namespace kelpie::learn
