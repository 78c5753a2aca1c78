// SPDX-License-Identifier: Apache-2.0
#include "tools/sim/bodies/KinematicBodies.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace kelpie::sim {
namespace {

// A robot seen from above: two discs, cm ahead of the neck base.
constexpr std::array<double, 2> kBodyDiscs{-2.0, -11.0};
constexpr double kBodyRadius = 7.0;
constexpr double kDiscReach = 11.1;  // cm from the neck base to the farther disc's centre
// cm that a disc must be from an obstacle's surface to be left out: no robot is pushed so far in a
// tick, whatever else pushes it.
constexpr double kFarOff = 40.0;
// cm that a ball goes in a tick at most, struck by the fastest foot (2) or rolling (2.4). What goes
// farther was squeezed out, to the other side of whoever squeezed it.
constexpr double kSqueezedOut = 3.0;
constexpr double kChinReach = 2.5;  // cm between ball and jaw that closes the chin switch
constexpr double kPawGives = 0.2;   // cm that a paw is pushed in before its switch closes [chosen]
constexpr double kRobotReach = 40.0;  // cm: no part of a robot is further from its neck base
constexpr double kGravity = 981.0;
// deg that the neck stands below its target without a ball under the chin (physics.md section 10).
constexpr double kEmptySag = 4.4;

// How far a robot's disc has to go until it is so far from there.
Point2<Field> wayOff(const RobotModel& robot, double disc, Point2<Field> from, double reach) {
  const Point2<Field> away = fieldFromRobot(robot.place().pose, {0.0, disc}) - from;
  const double gap = away.norm();
  if (gap >= reach || gap <= 0.0) return {};
  return away * ((reach - gap) / gap);
}

bool within(FieldPoint3 a, FieldPoint3 b, double reach) {
  const FieldPoint3 d = a - b;
  return d.x * d.x + d.y * d.y + d.z * d.z < reach * reach;
}

}  // namespace

std::array<double, 3> accelerationAtRest(const Stance& stance, const BodyFaults& faults) {
  const Angle tilt = stance.bodyTilt + faults.lean.tilt;
  const Angle roll = faults.lean.roll;
  const std::array<double, 3>& bias = faults.accelerationBias;
  return {-kGravity * tilt.sin() * roll.cos() + bias[0], kGravity * roll.sin() + bias[1],
          kGravity * tilt.cos() * roll.cos() + bias[2]};
}

void KinematicBodies::pushApart(std::size_t one, std::size_t other, Point2<Field> way) {
  robots_[one].push(way * 0.5);
  robots_[other].push(way * -0.5);
}

// Both give way alike: two robots that push against each other go nowhere, and one that pushes
// another that stands moves it at half its own speed.
void KinematicBodies::separate(std::size_t one, std::size_t other) {
  const double apart =
      distance(robots_[one].place().pose.position, robots_[other].place().pose.position);
  if (apart > 2.0 * (kDiscReach + kBodyRadius)) return;
  for (const double a : kBodyDiscs) {
    for (const double b : kBodyDiscs) {
      const Point2<Field> theirs = fieldFromRobot(robots_[other].place().pose, {0.0, b});
      pushApart(one, other, wayOff(robots_[one], a, theirs, 2.0 * kBodyRadius));
    }
  }
}

// Out of goals, beacons and each other.
void KinematicBodies::keepApart() {
  for (std::size_t i = 0; i < robots_.size(); ++i) {
    for (const double disc : kBodyDiscs) {
      const Point2<Field> centre = fieldFromRobot(robots_[i].place().pose, {0.0, disc});
      for (const Obstacle& obstacle : obstacles_) {
        const double reach = kBodyRadius + obstacle.radius;
        if (distance(nearestOn(obstacle, centre), centre) > reach + kFarOff) continue;
        robots_[i].push(wayOff(robots_[i], disc, nearestOn(obstacle, centre), reach));
      }
    }
    for (std::size_t k = 0; k < i; ++k) separate(i, k);
    const Point2<Field> p = robots_[i].place().pose.position;
    robots_[i].push(nearestWalkable(field_, p) - p);
  }
}

bool KinematicBodies::chinTouched(std::size_t robot, const BodySphere& head) const {
  const BodyPlace& place = robots_[robot].place();
  const Point2<Robot> ball = robotFromField(place.pose, ball_.position);
  const FieldPoint3 d =
      head.now - FieldPoint3{ball_.position.x, ball_.position.y, body::kBallRadius};
  const double gap = std::sqrt(d.x * d.x + d.y * d.y + d.z * d.z) - body::kBallRadius - head.radius;
  return d.z > 0.0 && gap < kChinReach && std::fabs(ball.x) < 5.0 && ball.y > 0.0;
}

// A part of a leg that is deeper inside something than its sole gives: it pushes.
bool KinematicBodies::pushes(std::size_t robot, const BodySphere& part) const {
  const double reach = part.radius - kPawGives;
  const Point2<Field> ground{part.now.x, part.now.y};
  for (const Obstacle& o : obstacles_)
    if (distance(nearestOn(o, ground), ground) < o.radius + reach) return true;
  for (std::size_t i = 0; i < robots_.size(); ++i) {
    const Point2<Field> other = robots_[i].place().pose.position;
    if (i == robot || distance(other, ground) > kRobotReach) continue;
    for (const BodySphere& theirs : robots_[i].spheres())
      if (within(theirs.now, part.now, theirs.radius + reach)) return true;
  }
  return false;
}

// Whether a paw is pressed: by the ground that it stands on, or by what it or a front leg's lower
// part pushes into.
std::array<bool, kLegCount> KinematicBodies::pawsPressed(
    std::size_t robot, const std::array<BodySphere, 9>& parts) const {
  std::array<bool, kLegCount> pressed = robots_[robot].onGround();
  for (std::size_t i = 0; i < kLegCount; ++i) pressed[i] = pressed[i] || pushes(robot, parts[i]);
  const std::size_t left = index(LegId::leftFront);
  const std::size_t right = index(LegId::rightFront);
  pressed[left] = pressed[left] || pushes(robot, parts[kLeftShin]);
  pressed[right] = pressed[right] || pushes(robot, parts[kRightShin]);
  return pressed;
}

BodyFeeling KinematicBodies::feel(std::size_t i) {
  const RobotModel& robot = robots_[i];
  BodyFeeling feeling;
  feeling.joints = robot.sensed();
  for (std::size_t j = 0; j < kJointCount; ++j) {
    const double error = robot.target().angle[j].rad() - robot.motors().angle[j].rad();
    const bool leg = j >= index(Joint::leftFrontRotator) && j <= index(Joint::rightHindKnee);
    const double gain = kDutyPerRad * (leg ? robot.legGain() : 1.0);
    feeling.duty[j] = maths::clamp(gain * error + robot.dutyNoise()[j], -1.0, 1.0);
  }
  feeling.acceleration = accelerationAtRest(robot.place().stance, robot.faults());
  const auto parts = robot.spheres();
  feeling.paw = pawsPressed(i, parts);
  feeling.touch = robot.touched();
  const bool holds = kicks_.holds(i);
  feeling.touch.chin = feeling.touch.chin || holds || chinTouched(i, parts.back());
  if (holdingPose(robot.target()) && !holds) {
    Angle& neck = feeling.joints[Joint::neckTilt];
    neck = neck - Angle::deg(kEmptySag);
  }
  return feeling;
}

// A ball that several squeeze, or that one holds, has nowhere to go: it stays and holds up who
// presses against it. Against a holder both give way alike, as without a ball.
void KinematicBodies::holdUp(const Ball& at) {
  ball_ = at;
  const auto holder = kicks_.holder();
  for (std::size_t i = 0; i < robots_.size(); ++i) {
    if (holder == i) continue;
    for (const double disc : kBodyDiscs) {
      const Point2<Field> way =
          wayOff(robots_[i], disc, ball_.position, kTrunkHalfWidth + body::kBallRadius);
      if (holder)
        pushApart(i, *holder, way);
      else
        robots_[i].push(way);
    }
  }
}

// Who kicks or holds the ball touches it more than who stands in its way in that tick. Off whom a
// kicked ball bounces at once is reported a tick later: it touched it last.
void KinematicBodies::tickBallAmongRobots() {
  ballToucher_.reset();
  std::vector<const RobotModel*> touching;
  for (std::size_t i = 0; i < robots_.size(); ++i) {
    const Ball before = ball_;
    if (!kicks_.tick(i, robots_[i], ball_)) touching.push_back(&robots_[i]);
    if (distance(before.velocity, ball_.velocity) > 0.0) ballToucher_ = i;
  }
  const Ball before = ball_;
  const BallTouch touch = tickBall(ball_, touching, obstacles_, ballParams_);
  const bool squeezed = touch.several && distance(before.position, ball_.position) > kSqueezedOut;
  if (squeezed) holdUp({before.position, {}});
  if (kicks_.holder()) return holdUp(before);
  const auto bouncedOff = std::exchange(bouncedOff_, std::nullopt);
  if (!touch.strongest) {
    if (!ballToucher_) ballToucher_ = bouncedOff;
    return;
  }
  auto& toucher = ballToucher_ ? bouncedOff_ : ballToucher_;
  toucher = static_cast<std::size_t>(touching[*touch.strongest] - robots_.data());
}

Status KinematicBodies::tick() {
  for (RobotModel& robot : robots_) robot.tick();
  keepApart();
  tickBallAmongRobots();
  return Done{};
}

}  // namespace kelpie::sim
