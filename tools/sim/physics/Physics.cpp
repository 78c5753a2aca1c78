// SPDX-License-Identifier: Apache-2.0
#include "tools/sim/physics/Physics.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "tools/sim/physics/Things.h"
#include "tools/sim/physics/Units.h"

namespace kelpie::sim {
namespace {

constexpr double kBallStep = 0.001;  // s, while the ball may touch a robot
constexpr double kReach = 0.13;   // m from a part's centre to the ball's within which it may touch
constexpr double kLying = 0.003;  // m over the carpet below which the ball rolls on it
constexpr double kAtRest = 1e-3;  // m/s below which rolling resistance fades
constexpr double kMinImpulse = 1e-5;  // N s: 0.3 mm/s of a ball of 36 g

}  // namespace

Expected<Physics> Physics::build(const body::FieldDescription& field, const RobotsPhysics& robots,
                                 const PhysicsParams& world) {
  Expected<Engine> engine = Engine::load(worldXml(field, robots, world));
  if (!engine) return Error{engine.error()};
  Physics physics(std::move(*engine), field, robots, world);
  const Status furnished = physics.setObstacles(obstaclesOf(field));
  if (!furnished) return Error{furnished.error()};
  return physics;
}

Physics::Physics(Engine engine, const body::FieldDescription& field, RobotsPhysics params,
                 const PhysicsParams& world)
    : engine_(std::move(engine)), field_(field), params_(std::move(params)), world_(world) {
  for (std::size_t i = 0; i < params_.size(); ++i) robots_.emplace_back(engine_, i);
  ballBody_ = engine_.body("ball");
  const int free = engine_.joint("ball");
  ballQpos_ = engine_.model().jnt_qposadr[free];
  ballDof_ = engine_.model().jnt_dofadr[free];
}

void Physics::putRobot(std::size_t i, const Pose2& pose, const JointAngles& joints) {
  robots_[i].place(pose, joints, engine_);
}

void Physics::putBall(const Ball& ball) {
  mjData& data = engine_.data();
  mjtNum* q = data.qpos + ballQpos_;
  q[0] = kCm * ball.position.x;
  q[1] = kCm * ball.position.y;
  q[2] = kCm * body::kBallRadius;
  mjtNum* v = data.qvel + ballDof_;
  v[0] = kCm * ball.velocity.x;
  v[1] = kCm * ball.velocity.y;
  v[2] = 0.0;
  // It rolls: v = w x r.
  const double radius = kCm * body::kBallRadius;
  v[3] = -v[1] / radius;
  v[4] = v[0] / radius;
  v[5] = 0.0;
  q[3] = 1.0;
  q[4] = q[5] = q[6] = 0.0;
}

Ball Physics::ball() const {
  const mjtNum* q = engine_.data().qpos + ballQpos_;
  const mjtNum* v = engine_.data().qvel + ballDof_;
  return {{q[0] / kCm, q[1] / kCm}, {v[0] / kCm, v[1] / kCm}};
}

double Physics::ballHeight() const { return engine_.data().qpos[ballQpos_ + 2] / kCm; }

Status Physics::setObstacles(const std::vector<Obstacle>& obstacles) {
  return putThings(obstacles, field_, engine_);
}

bool Physics::ballNearRobot() const {
  const mjData& data = engine_.data();
  const mjtNum* b = data.xpos + 3 * ballBody_;
  for (int body = 1; body < engine_.model().nbody; ++body) {
    if (body == ballBody_) continue;
    const mjtNum* p = data.xpos + 3 * body;
    const double x = p[0] - b[0];
    const double y = p[1] - b[1];
    if (x * x + y * y < kReach * kReach) return true;
  }
  return false;
}

// Rolling resistance as a force at the ball's centre; of a ball that rolls without slipping, 5/3 of
// its mass are to be braked.
void Physics::rollBall() {
  mjData& data = engine_.data();
  mjtNum* force = data.qfrc_applied + ballDof_;
  force[0] = force[1] = 0.0;
  if (data.qpos[ballQpos_ + 2] > kCm * body::kBallRadius + kLying) return;
  const mjtNum* v = data.qvel + ballDof_;
  const double speed = maths::hypot(v[0], v[1]);
  if (speed <= 0.0) return;
  const PhysicalBallParams& p = world_.ball;
  const double brake = p.drag * speed + p.roll * std::fmin(1.0, speed / kAtRest);
  const double share = -5.0 / 3.0 * p.mass * brake / speed;
  force[0] = share * v[0];
  force[1] = share * v[1];
}

void Physics::feelPushes(double seconds) {
  for (std::size_t i = 0; i < robots_.size(); ++i)
    pushes_[i] += seconds * robots_[i].pushOnBall(engine_);
}

std::optional<std::size_t> Physics::ballToucher() const {
  const auto max = std::max_element(pushes_.begin(), pushes_.end());
  if (max == pushes_.end() || *max < kMinImpulse) return std::nullopt;
  return static_cast<std::size_t>(max - pushes_.begin());
}

Status Physics::tick() {
  double left = kTickSeconds;
  pushes_.assign(robots_.size(), 0.0);
  while (left > 0.5e-3) {
    const double longest = ballNearRobot() ? std::fmin(kBallStep, world_.step) : world_.step;
    const double step = std::fmin(left, longest);
    rollBall();
    const Status stepped = engine_.step(step);
    if (!stepped) return stepped;
    if (longest == kBallStep) feelPushes(step);
    left -= step;
  }
  return Done{};
}

}  // namespace kelpie::sim
