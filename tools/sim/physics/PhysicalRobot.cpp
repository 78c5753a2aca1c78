// SPDX-License-Identifier: Apache-2.0
#include "tools/sim/physics/PhysicalRobot.h"

#include <fmt/format.h>

#include <cmath>

#include "robot/body/Ers7.h"
#include "tools/sim/physics/RobotXml.h"
#include "tools/sim/physics/Units.h"

namespace kelpie::sim {
namespace {

constexpr double kPawForce = 0.3;      // N that closes a paw's switch [chosen]
constexpr double kUpright = 90.0;      // deg from a heading to the turn of the torso's axes
constexpr double kClearance = 0.0005;  // m under the lowest paw of a robot that is put down

double normalForce(const Engine& engine, int contact) {
  std::array<mjtNum, 6> force{};
  mj_contactForce(&engine.model(), &engine.data(), contact, force.data());
  return std::fabs(force[0]);
}

// The least height of robot's geoms over the carpet, by their bounding spheres but for paws.
double lowest(const Engine& engine, const std::array<int, kLegCount>& paws) {
  double min = 1.0;
  for (const int paw : paws)
    min = std::fmin(min, engine.data().geom_xpos[3 * paw + 2] - engine.model().geom_size[3 * paw]);
  return min;
}

}  // namespace

PhysicalRobot::PhysicalRobot(const Engine& engine, std::size_t number) {
  const mjModel& model = engine.model();
  const auto name = [&](const std::string& part) { return fmt::format("r{}_{}", number, part); };
  trunk_ = engine.body(name("trunk"));
  const int free = engine.joint(name("free"));
  freeQpos_ = model.jnt_qposadr[free];
  freeDof_ = model.jnt_dofadr[free];
  accelerometer_ = static_cast<int>(3 * number);
  for (std::size_t j = 0; j < kServoCount; ++j) {
    qpos_[j] = model.jnt_qposadr[engine.joint(name(fmt::format("{}", j)))];
    actuator_[j] = engine.actuator(name(fmt::format("{}", j)));
  }
  for (std::size_t i = 0; i < kLegCount; ++i) paw_[i] = engine.geom(name(fmt::format("paw{}", i)));
  chin_ = engine.geom(name("chin"));
  jaw_ = engine.geom(name("jaw"));
  ball_ = engine.geom("ball");
  firstGeom_ = engine.geom(name("trunk"));
  lastGeom_ = jaw_;
}

void PhysicalRobot::place(const Pose2& pose, const JointAngles& joints, Engine& engine) const {
  mjData& data = engine.data();
  for (std::size_t j = 0; j < kServoCount; ++j) data.qpos[qpos_[j]] = joints.angle[j].rad();
  const Stance stance = body::stanceFromLegs(joints);
  const double half = 0.5 * (pose.heading - Angle::deg(kUpright)).rad();
  const double tilt = -0.5 * stance.bodyTilt.rad();
  mjtNum* q = data.qpos + freeQpos_;
  // Of the turn about the vertical after the tilt about the axis to the right.
  const maths::SinCos t = maths::sinCos(half);
  const maths::SinCos l = maths::sinCos(tilt);
  q[3] = t.cos * l.cos;
  q[4] = t.cos * l.sin;
  q[5] = t.sin * l.sin;
  q[6] = t.sin * l.cos;
  const Point3<Robot> origin = body::robotFromTorso(stance, {0.0, 0.0, 0.0});
  const Point2<Field> at = fieldFromRobot(pose, {origin.x, origin.y});
  q[0] = kCm * at.x;
  q[1] = kCm * at.y;
  q[2] = kCm * origin.z;
  for (int v = 0; v < 6 + static_cast<int>(kServoCount); ++v) data.qvel[freeDof_ + v] = 0.0;
  mj_kinematics(&engine.model(), &data);
  q[2] += kClearance - lowest(engine, paw_);
}

void PhysicalRobot::command(const JointAngles& target, const std::array<double, kJointCount>& gain,
                            const ServoParams& servo, Engine& engine) const {
  mjModel& model = engine.model();
  for (std::size_t j = 0; j < kServoCount; ++j) {
    const double kp = gain[j] * servoOf(j, servo).kp;
    model.actuator_gainprm[mjNGAIN * actuator_[j]] = kp;
    model.actuator_biasprm[mjNBIAS * actuator_[j] + 1] = -kp;
    engine.data().ctrl[actuator_[j]] = target.angle[j].rad();
  }
}

void PhysicalRobot::shift(Point2<Field> way, Angle turn, Engine& engine) const {
  mjtNum* q = engine.data().qpos + freeQpos_;
  q[0] += kCm * way.x;
  q[1] += kCm * way.y;
  const maths::SinCos t = maths::sinCos(0.5 * turn.rad());
  const std::array<mjtNum, 4> about{t.cos, 0.0, 0.0, t.sin};
  std::array<mjtNum, 4> turned{};
  mju_mulQuat(turned.data(), about.data(), q + 3);
  for (std::size_t k = 0; k < 4; ++k) q[3 + k] = turned[k];
}

JointAngles PhysicalRobot::joints(const Engine& engine) const {
  JointAngles joints;
  for (std::size_t j = 0; j < kServoCount; ++j)
    joints.angle[j] = Angle::rad(engine.data().qpos[qpos_[j]]);
  return joints;
}

// The torso's axes are the robot frame's after a roll and, before it, a tilt (BodyShape.h): right
// stays level but for the roll.
BodyPlace PhysicalRobot::bodyPlace(const Engine& engine) const {
  const mjtNum* r = engine.data().xmat + 9 * trunk_;
  const mjtNum* o = engine.data().xpos + 3 * trunk_;
  const double behind = -kCm * body::kNeckBehindShoulder;
  const double above = kCm * body::kNeckAboveShoulder;
  const auto neck = [&](std::size_t axis) {
    return (o[axis] + r[3 * axis + 1] * behind + r[3 * axis + 2] * above) / kCm;
  };
  BodyPlace place;
  place.joints = joints(engine);
  place.pose.position = {neck(0), neck(1)};
  place.pose.heading = Angle::rad(maths::atan2(r[3], r[0])) + Angle::deg(kUpright);
  place.lean.roll = Angle::rad(maths::asin(maths::clamp(-r[6], -1.0, 1.0)));
  place.stance.bodyTilt = Angle::rad(-maths::atan2(r[7], r[8]));
  const maths::SinCos tilt = maths::sinCos(place.stance.bodyTilt.rad());
  place.stance.shoulderHeight =
      neck(2) - body::kNeckAboveShoulder * tilt.cos - body::kNeckBehindShoulder * tilt.sin;
  return place;
}

RawFeeling PhysicalRobot::feeling(const ServoParams& servo, const Engine& engine) const {
  const mjData& data = engine.data();
  RawFeeling feeling;
  for (std::size_t j = 0; j < kServoCount; ++j)
    feeling.duty[j] = data.actuator_force[actuator_[j]] / servoOf(j, servo).stall;
  const mjtNum* a = data.sensordata + accelerometer_;  // right, ahead, up
  feeling.acceleration = {a[1] / kCm, -a[0] / kCm, a[2] / kCm};
  for (int c = 0; c < data.ncon; ++c) {
    const int one = data.contact[c].geom1;
    const int other = data.contact[c].geom2;
    if (!owns(one) && !owns(other)) continue;
    for (std::size_t i = 0; i < kLegCount; ++i)
      if ((one == paw_[i] || other == paw_[i]) && normalForce(engine, c) > kPawForce)
        feeling.paw[i] = true;
    const int mine = owns(one) ? one : other;
    if ((one == ball_ || other == ball_) && (mine == chin_ || mine == jaw_)) feeling.chin = true;
  }
  return feeling;
}

double PhysicalRobot::pushOnBall(const Engine& engine) const {
  const mjData& data = engine.data();
  double push = 0.0;
  for (int c = 0; c < data.ncon; ++c) {
    const int one = data.contact[c].geom1;
    const int other = data.contact[c].geom2;
    if ((one == ball_ && owns(other)) || (other == ball_ && owns(one)))
      push += normalForce(engine, c);
  }
  return push;
}

}  // namespace kelpie::sim
