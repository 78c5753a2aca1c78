// SPDX-License-Identifier: Apache-2.0
#include "tools/sim/world/BallContact.h"

#include <algorithm>
#include <cmath>

namespace kelpie::sim {
namespace {

constexpr int kSteps = 4;
constexpr double kTiny = 1e-9;
constexpr double kMaxSqueeze = 120.0;  // cm/s that a foot coming down gives a ball below it

void limitSpeed(Ball& ball, const BallParams& params) {
  const double speed = ball.velocity.norm();
  if (speed > params.maxSpeed) ball.velocity = ball.velocity * (params.maxSpeed / speed);
}

void touchSphere(Ball& ball, const BodySphere& sphere, double t, const BallParams& params) {
  const FieldPoint3 centre = between(sphere.before, sphere.now, t);
  const double reach = body::kBallRadius + sphere.radius;
  const double up = centre.z - body::kBallRadius;
  const double clear2 = reach * reach - up * up;
  if (clear2 <= 0.0) return;
  const double clear = std::sqrt(clear2);
  const Point2<Field> away = ball.position - Point2<Field>{centre.x, centre.y};
  const double gap = away.norm();
  if (gap >= clear) return;
  const Point2<Field> n = gap > kTiny ? away * (1.0 / gap) : Point2<Field>{1.0, 0.0};
  const double vx = (sphere.now.x - sphere.before.x) / kTickSeconds;
  const double vy = (sphere.now.y - sphere.before.y) / kTickSeconds;
  const double vz = (sphere.now.z - sphere.before.z) / kTickSeconds;
  // A part coming down beside the ball wedges it away.
  const double wedge = maths::clamp(-up * vz / std::max(clear, 0.5), -kMaxSqueeze, kMaxSqueeze);
  strike(ball, {n, clear - gap, vx * n.x + vy * n.y + std::max(wedge, 0.0)}, params.restitution);
}

Pose2 poseBetween(const RobotModel& robot, double t) {
  const Pose2& a = robot.placeBefore().pose;
  const Pose2& b = robot.place().pose;
  return {a.position + (b.position - a.position) * t, a.heading + (b.heading - a.heading) * t};
}

// The trunk's nearest point to the ball, in the robot frame; a ball inside leaves by the nearest
// side.
Point2<Robot> trunkSurface(Point2<Robot> p, bool& inside) {
  Point2<Robot> q{maths::clamp(p.x, -kTrunkHalfWidth, kTrunkHalfWidth),
                  maths::clamp(p.y, kTrunkBack, kChestAhead)};
  inside = q.x == p.x && q.y == p.y;
  if (!inside) return q;
  const double lateral = kTrunkHalfWidth - std::fabs(p.x);
  const double ahead = kChestAhead - p.y;
  const double behind = p.y - kTrunkBack;
  if (ahead <= lateral && ahead <= behind) return {p.x, kChestAhead};
  if (behind <= lateral) return {p.x, kTrunkBack};
  return {p.x < 0.0 ? -kTrunkHalfWidth : kTrunkHalfWidth, p.y};
}

void touchTrunk(Ball& ball, const RobotModel& robot, double t, const BallParams& params) {
  const Pose2 pose = poseBetween(robot, t);
  const Point2<Robot> local = robotFromField(pose, ball.position);
  bool inside = false;
  const Point2<Robot> surface = trunkSurface(local, inside);
  const Point2<Robot> away = inside ? surface - local : local - surface;
  const double gap = away.norm();
  if (!inside && gap >= body::kBallRadius) return;
  const Point2<Field> contact = fieldFromRobot(pose, surface);
  const Point2<Field> tip = fieldFromRobot(pose, surface + away);
  const Point2<Field> n = gap > kTiny ? (tip - contact) * (1.0 / gap) : Point2<Field>{0.0, 1.0};
  const Point2<Field> was = fieldFromRobot(robot.placeBefore().pose, surface);
  const Point2<Field> is = fieldFromRobot(robot.place().pose, surface);
  const Point2<Field> v = (is - was) * (1.0 / kTickSeconds);
  const double depth = inside ? body::kBallRadius + gap : body::kBallRadius - gap;
  strike(ball, {n, depth, v.x * n.x + v.y * n.y}, params.restitution);
}

void touch(Ball& ball, const RobotModel& robot, double t, const BallParams& params) {
  for (const BodySphere& sphere : robot.spheres()) touchSphere(ball, sphere, t, params);
  touchTrunk(ball, robot, t, params);
}

}  // namespace

BallTouch tickBall(Ball& ball, const std::vector<const RobotModel*>& robots,
                   const std::vector<Obstacle>& obstacles, const BallParams& params) {
  constexpr double kNearby = 40.0;  // no part of a robot is further from its neck base
  BallTouch touched;
  std::optional<std::size_t> first;
  double max = 0.0;
  for (int step = 1; step <= kSteps; ++step) {
    const double t = static_cast<double>(step) / kSteps;
    roll(ball, kTickSeconds / kSteps, params);
    for (std::size_t i = 0; i < robots.size(); ++i) {
      if (distance(robots[i]->place().pose.position, ball.position) > kNearby) continue;
      const Ball before = ball;
      touch(ball, *robots[i], t, params);
      if (distance(before.position, ball.position) <= 0.0) continue;
      if (!first) first = i;
      touched.several = touched.several || *first != i;
      const double change = distance(before.velocity, ball.velocity);
      if (change <= max) continue;
      max = change;
      touched.strongest = i;
    }
    bounce(ball, obstacles, params);
    limitSpeed(ball, params);
  }
  return touched;
}

}  // namespace kelpie::sim
