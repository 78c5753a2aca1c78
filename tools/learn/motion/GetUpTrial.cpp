// SPDX-License-Identifier: Apache-2.0
#include "tools/learn/motion/GetUpTrial.h"

#include <array>
#include <cmath>

#include "robot/core/Random.h"

namespace kelpie::learn {
namespace {

constexpr double kMessageSeconds = kTickSeconds * kTicksPerMessage;
constexpr double kOff = 8.0;         // deg, sd of how a robot lies otherwise [chosen]
constexpr double kDrop = 0.01;       // m that all of it is over the carpet
constexpr double kLies = 0.8;        // s until it is at rest
constexpr double kStands = 0.5;      // s after the motion for which it is watched
constexpr double kStanding = 0.906;  // cosine of 25 deg
constexpr double kLying = 0.5;       // cosine of 60 deg

using Quaternion = std::array<mjtNum, 4>;

// About an axis of the torso: right, ahead, up.
Quaternion turnAbout(std::size_t axis, Angle angle) {
  const maths::SinCos half = maths::sinCos(0.5 * angle.rad());
  Quaternion turn{half.cos, 0.0, 0.0, 0.0};
  turn[axis + 1] = half.sin;
  return turn;
}

Quaternion after(const Quaternion& first, const Quaternion& then) {
  Quaternion both{};
  mju_mulQuat(both.data(), then.data(), first.data());
  return both;
}

Quaternion lying(FallSide side) {
  switch (side) {
    case FallSide::front: return turnAbout(0, Angle::deg(-90.0));
    case FallSide::back: return turnAbout(1, Angle::deg(180.0));
    case FallSide::left: return turnAbout(1, Angle::deg(-90.0));
    case FallSide::right: return turnAbout(1, Angle::deg(90.0));
    default: return {1.0, 0.0, 0.0, 0.0};
  }
}

sim::Engine& engineOf(PhysicalWalker& walker) { return walker.bodies().physics().engine(); }

// By the spheres about its parts.
double lowest(const sim::PhysicalRobot& robot, const sim::Engine& engine) {
  double min = 1.0;
  for (int geom = 0; geom < engine.model().ngeom; ++geom)
    if (robot.owns(geom))
      min =
          std::fmin(min, engine.data().geom_xpos[3 * geom + 2] - engine.model().geom_rbound[geom]);
  return min;
}

const mjtNum* trunkAxes(PhysicalWalker& walker) {
  const int trunk = walker.bodies().physics().robot(0).trunk();
  return engineOf(walker).data().xmat + 9 * trunk;
}

double tryToGetUp(const actuator::ActuatorParams& params, FallSide side,
                  const sim::PhysicsParams& model, std::uint64_t seed) {
  PhysicalWalker walker(model, params, seed);
  layDown(side, seed, walker);
  for (double t = 0.0; t < kLies; t += kMessageSeconds) walker.step({});
  Command command;
  command.motion = getUpMotion(side);
  const double motion = kTickSeconds * ticksOf(params.motions[command.motion]);
  double gain = 0.0;
  for (double t = 0.0; t < motion + kStands; t += kMessageSeconds) {
    walker.step(command);
    if (walker.failed()) return 0.0;
    gain += 0.1 * uprightness(walker) * kMessageSeconds / (motion + kStands);
  }
  return gain + 0.45 * (1.0 + uprightness(walker)) + (standsUpright(walker) ? 1.0 : 0.0);
}

}  // namespace

void layDown(FallSide side, std::uint64_t seed, PhysicalWalker& walker) {
  Random random(seed ^ 0xfa11ULL);
  const sim::PhysicalRobot& robot = walker.bodies().physics().robot(0);
  sim::Engine& engine = engineOf(walker);
  const int free = engine.model().body_jntadr[robot.trunk()];
  mjtNum* q = engine.data().qpos + engine.model().jnt_qposadr[free];
  mjtNum* v = engine.data().qvel + engine.model().jnt_dofadr[free];
  Quaternion turn = lying(side);
  for (std::size_t axis = 0; axis < 3; ++axis)
    turn = after(turnAbout(axis, Angle::deg(random.gaussian(0.0, kOff))), turn);
  for (std::size_t k = 0; k < 4; ++k) q[3 + k] = turn[k];
  for (std::size_t k = 0; k < 6; ++k) v[k] = 0.0;
  mj_kinematics(&engine.model(), &engine.data());
  q[2] += kDrop - lowest(robot, engine);
  (void)engine.settle();  // a fault shows in the next tick
}

double uprightness(PhysicalWalker& walker) { return trunkAxes(walker)[8]; }

bool standsUpright(PhysicalWalker& walker) {
  return !walker.failed() && uprightness(walker) > kStanding;
}

// The third row of the trunk's axes: how far right, ahead and up of the body point up.
FallSide trueSide(PhysicalWalker& walker) {
  const mjtNum* axes = trunkAxes(walker);
  if (axes[8] > kLying) return FallSide::none;
  const double back = std::fmax(-axes[8], axes[7]);
  const double side = std::fabs(axes[6]);
  if (-axes[7] > std::fmax(back, side)) return FallSide::front;
  if (back > side) return FallSide::back;
  return axes[6] > 0.0 ? FallSide::left : FallSide::right;
}

MotionKind getUpMotion(FallSide side) {
  switch (side) {
    case FallSide::front: return MotionKind::getUpFront;
    case FallSide::back: return MotionKind::getUpBack;
    case FallSide::left: return MotionKind::getUpLeft;
    case FallSide::right: return MotionKind::getUpRight;
    default: return MotionKind::none;
  }
}

double getUpGain(const actuator::MotionData& motion, FallSide side,
                 const std::vector<sim::PhysicsParams>& models, std::uint64_t seed) {
  actuator::ActuatorParams params;
  params.motions[getUpMotion(side)] = motion;
  double sum = 0.0;
  for (std::size_t i = 0; i < models.size(); ++i)
    sum += tryToGetUp(params, side, models[i], seed + i);
  return models.empty() ? 0.0 : sum / static_cast<double>(models.size());
}

}  // namespace kelpie::learn
