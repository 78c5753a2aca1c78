// SPDX-License-Identifier: Apache-2.0
#include "tools/sim/physics/PhysicalBodies.h"

#include <cmath>
#include <utility>

#include "robot/body/Ers7.h"
#include "tools/sim/physics/Units.h"

namespace kelpie::sim {
namespace {

constexpr int kHandStays = 25;  // ticks that a hand needs to let go: 0.2 s [chosen]
// A hand round the trunk: a spring that a walking robot moves by a few mm [chosen].
constexpr double kHandSpring = 600.0;  // N/m
constexpr double kHandDamping = 30.0;  // N s/m
constexpr double kHandTurn = 6.0;      // N m/rad
constexpr double kHandTurnDamping = 0.2;
// One that holds only a share of the way lets itself be dragged: what remains brakes.
constexpr double kDrag = 40.0;  // N s/m at a share of one half [chosen]

bool isLeg(std::size_t joint) {
  return joint >= index(Joint::leftFrontRotator) && joint <= index(Joint::rightHindKnee);
}

}  // namespace

Expected<std::unique_ptr<PhysicalBodies>> PhysicalBodies::build(
    const body::FieldDescription& field, const std::vector<PhysicalStart>& robots,
    const PhysicsParams& world, const PhysicalSensorParams& sensors) {
  RobotsPhysics params;
  for (const PhysicalStart& robot : robots) params.push_back(robot.params);
  Expected<Physics> physics = Physics::build(field, params, world);
  if (!physics) return Error{physics.error()};
  std::unique_ptr<PhysicalBodies> bodies(new PhysicalBodies(std::move(*physics), sensors));
  for (std::size_t i = 0; i < robots.size(); ++i) {
    const PhysicalStart& start = robots[i];
    bodies->robots_.push_back({CommandQueue(startingPose()),
                               Backlash(start.faults.play),
                               start.faults,
                               Random(start.seed),
                               {},
                               {},
                               0.0,
                               0.0,
                               {},
                               0.0,
                               0,
                               {}});
    bodies->physics_.putRobot(i, start.pose, startingPose());
  }
  const Status settled = bodies->physics_.engine().settle();
  if (!settled) return Error{settled.error()};
  for (std::size_t i = 0; i < robots.size(); ++i) bodies->readPlace(i);
  return bodies;
}

void PhysicalBodies::drive(std::size_t i) {
  Robot& robot = robots_[i];
  robot.queue.play();
  std::array<double, kJointCount> gain{};
  for (std::size_t j = 0; j < kJointCount; ++j) {
    if (robot.queue.held(j)) gain[j] = isLeg(j) ? robot.queue.legGain() : 1.0;
  }
  physics_.robot(i).command(throughGears(i), gain, physics_.params(i).servo, physics_.engine());
}

// A gear with play moves what is behind it only at the ends of the play.
JointAngles PhysicalBodies::throughGears(std::size_t i) {
  Robot& robot = robots_[i];
  const double half = 0.5 * physics_.params(i).servo.legPlay;
  JointAngles targets = robot.queue.target();
  for (std::size_t j = 0; j < kServoCount; ++j) {
    if (!isLeg(j)) continue;
    const double motor = targets.angle[j].rad();
    robot.driven[j] = maths::clamp(robot.driven[j], motor - half, motor + half);
    targets.angle[j] = Angle::rad(robot.driven[j]);
  }
  return targets;
}

// Forces of a hand on the trunk.
void PhysicalBodies::pull(std::size_t i) {
  const Robot& robot = robots_[i];
  const PhysicalRobot& body = physics_.robot(i);
  mjData& data = physics_.engine().data();
  mjtNum* force = data.xfrc_applied + 6 * body.trunk();
  for (int k = 0; k < 6; ++k) force[k] = 0.0;
  if (robot.held <= 0.0 && robot.lifted <= 0.0) return;
  const mjtNum* v = body.velocity(physics_.engine());
  const bool fast = robot.held >= 1.0 || robot.lifted > 0.0;
  if (!fast) {
    const double drag = kDrag * robot.held / (1.0 - robot.held);
    force[0] = -drag * v[0];
    force[1] = -drag * v[1];
    return;
  }
  const Point2<Field> off = robot.anchor.position - robot.place.pose.position;
  force[0] = kHandSpring * kCm * off.x - kHandDamping * v[0];
  force[1] = kHandSpring * kCm * off.y - kHandDamping * v[1];
  const double turn = (robot.anchor.heading - robot.place.pose.heading).rad();
  // A free body's angular velocity is in its own axes; a robot on its back turns the other way.
  const mjtNum* r = data.xmat + 9 * body.trunk();
  const double turning = r[6] * v[3] + r[7] * v[4] + r[8] * v[5];
  force[5] = kHandTurn * turn - kHandTurnDamping * turning;
  if (robot.lifted <= 0.0) return;
  const double height = robot.anchorHeight + kCm * robot.lifted;
  force[2] = 2.0 * kHandSpring * (height - data.xpos[3 * body.trunk() + 2]) - kHandDamping * v[2];
}

void PhysicalBodies::readPlace(std::size_t i) {
  Robot& robot = robots_[i];
  robot.place = physics_.robot(i).bodyPlace(physics_.engine());
  robot.place.joints[Joint::tailTilt] = robot.queue.target()[Joint::tailTilt];
  robot.place.joints[Joint::tailPan] = robot.queue.target()[Joint::tailPan];
  robot.place.joints = robot.neck.step(robot.place.joints);
  robot.place.lean.tilt = robot.faults.lean.tilt;
  robot.place.lean.roll = robot.place.lean.roll + robot.faults.lean.roll;
}

Status PhysicalBodies::tick() {
  for (std::size_t i = 0; i < robots_.size(); ++i) {
    drive(i);
    pull(i);
    robots_[i].handTicks = std::max(0, robots_[i].handTicks - 1);
  }
  const Status moved = physics_.tick();
  if (!moved) return moved;
  for (std::size_t i = 0; i < robots_.size(); ++i) readPlace(i);
  return Done{};
}

BodyFeeling PhysicalBodies::feel(std::size_t i) {
  Robot& robot = robots_[i];
  const RawFeeling raw = physics_.robot(i).feeling(physics_.params(i).servo, physics_.engine());
  BodyFeeling feeling;
  feeling.joints = physics_.robot(i).joints(physics_.engine());
  for (std::size_t j = kServoCount; j < kJointCount; ++j)
    feeling.joints.angle[j] = robot.queue.target().angle[j];
  for (std::size_t j = 0; j < kJointCount; ++j) {
    const double noise = robot.random.gaussian(0.0, sensors_.jointNoiseSd);
    feeling.joints.angle[j] = feeling.joints.angle[j] + Angle::rad(noise);
    feeling.duty[j] =
        maths::clamp(raw.duty[j] + robot.random.gaussian(0.0, sensors_.dutyNoise), -1.0, 1.0);
  }
  feeling.acceleration = raw.acceleration;
  for (std::size_t k = 0; k < 3; ++k) feeling.acceleration[k] += robot.faults.accelerationBias[k];
  feeling.paw = raw.paw;
  feeling.touch = robot.touch;
  feeling.touch.chin = feeling.touch.chin || raw.chin;
  feeling.touch.back[1] = feeling.touch.back[1] || robot.lifted > 0.0 || robot.handTicks > 0;
  return feeling;
}

std::array<bool, kLegCount> PhysicalBodies::onGround(std::size_t i) const {
  return physics_.robot(i).feeling(physics_.params(i).servo, physics_.engine()).paw;
}

void PhysicalBodies::carry(std::size_t i, const Pose2& pose) {
  Robot& robot = robots_[i];
  physics_.putRobot(i, pose, physics_.robot(i).joints(physics_.engine()));
  (void)physics_.engine().settle();  // a fault shows in the next tick
  robot.handTicks = kHandStays;
  robot.anchor = pose;
  readPlace(i);
}

void PhysicalBodies::hold(std::size_t i, double share) {
  if (robots_[i].held <= 0.0) robots_[i].anchor = robots_[i].place.pose;
  robots_[i].held = share;
}

void PhysicalBodies::shove(std::size_t i, Point2<Field> way, Angle turn) {
  physics_.robot(i).shift(way, turn, physics_.engine());
  robots_[i].anchor.position = robots_[i].anchor.position + way;
}

void PhysicalBodies::lift(std::size_t i, double height) {
  Robot& robot = robots_[i];
  if (robot.lifted <= 0.0) {
    if (robot.held <= 0.0) robot.anchor = robot.place.pose;
    robot.anchorHeight = physics_.engine().data().xpos[3 * physics_.robot(i).trunk() + 2];
  }
  if (robot.lifted > 0.0 && height <= 0.0) robot.handTicks = kHandStays;
  robot.lifted = height;
}

}  // namespace kelpie::sim
