// SPDX-License-Identifier: Apache-2.0
#include "tools/sim/Ball.h"

#include <algorithm>
#include <cmath>

namespace kelpie::sim {
namespace {

constexpr int kSteps = 4;
constexpr double kWallHalf = 0.6;  // cm, half the thickness of a goal's wall
constexpr double kPostRadius = 1.0;
constexpr double kTiny = 1e-9;
constexpr double kMaxSqueeze = 120.0;  // cm/s that a foot coming down gives a ball below it

void limitSpeed(Ball& ball, const BallParams& params) {
  const double speed = ball.velocity.norm();
  if (speed > params.maxSpeed) ball.velocity = ball.velocity * (params.maxSpeed / speed);
}

// A surface with horizontal normal n (towards the ball) moving at `speed` along it, `depth` inside
// the ball.
struct Touch {
  Point2<Field> normal;
  double depth = 0.0;
  double speed = 0.0;
};

void apply(Ball& ball, const Touch& touch, double restitution) {
  ball.position = ball.position + touch.normal * touch.depth;
  const double closing =
      touch.speed - (ball.velocity.x * touch.normal.x + ball.velocity.y * touch.normal.y);
  if (closing > 0.0) {
    ball.velocity = ball.velocity + touch.normal * ((1.0 + restitution) * closing);
  }
}

FieldPoint3 between(FieldPoint3 a, FieldPoint3 b, double t) {
  return {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y), a.z + t * (b.z - a.z)};
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
  apply(ball, {n, clear - gap, vx * n.x + vy * n.y + std::max(wedge, 0.0)}, params.restitution);
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
  const double aside = kTrunkHalfWidth - std::fabs(p.x);
  const double ahead = kChestAhead - p.y;
  const double behind = p.y - kTrunkBack;
  if (ahead <= aside && ahead <= behind) return {p.x, kChestAhead};
  if (behind <= aside) return {p.x, kTrunkBack};
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
  apply(ball, {n, depth, v.x * n.x + v.y * n.y}, params.restitution);
}

void addGoal(std::vector<Obstacle>& obstacles, const body::FieldDescription& field,
             Point2<Field> mouth) {
  const double half = field.goalWidth / 2.0;
  const double back =
      mouth.y < field.length / 2.0 ? mouth.y - field.goalDepth : mouth.y + field.goalDepth;
  const Point2<Field> left{mouth.x - half, mouth.y};
  const Point2<Field> right{mouth.x + half, mouth.y};
  const Point2<Field> leftBack{left.x, back};
  const Point2<Field> rightBack{right.x, back};
  obstacles.push_back({left, leftBack, kWallHalf});
  obstacles.push_back({right, rightBack, kWallHalf});
  obstacles.push_back({leftBack, rightBack, kWallHalf});
  obstacles.push_back({left, left, kPostRadius});
  obstacles.push_back({right, right, kPostRadius});
}

}  // namespace

std::vector<Obstacle> obstaclesOf(const body::FieldDescription& field) {
  std::vector<Obstacle> obstacles;
  for (const body::Landmark& mark : field.landmarks) {
    if (mark.kind == LandmarkKind::goalBlue || mark.kind == LandmarkKind::goalYellow) {
      addGoal(obstacles, field, mark.position);
    } else {
      obstacles.push_back({mark.position, mark.position, field.beaconRadius});
    }
  }
  return obstacles;
}

Point2<Field> nearestOn(const Obstacle& obstacle, Point2<Field> p) {
  const Point2<Field> along = obstacle.b - obstacle.a;
  const double length2 = along.x * along.x + along.y * along.y;
  if (length2 <= 0.0) return obstacle.a;
  const Point2<Field> d = p - obstacle.a;
  return obstacle.a + along * maths::clamp((d.x * along.x + d.y * along.y) / length2, 0.0, 1.0);
}

void roll(Ball& ball, double seconds, const BallParams& params) {
  const double speed = ball.velocity.norm();
  if (speed <= kTiny) {
    ball.velocity = {};
    return;
  }
  const double k = -maths::log(params.keptPerFrame) / kFrameSeconds;
  const double floor = k > kTiny ? params.friction / k : 0.0;
  double time = seconds;
  if (k > kTiny && floor > 0.0) {
    time = std::min(seconds, maths::log(1.0 + speed / floor) / k);
  } else if (params.friction > 0.0) {
    time = std::min(seconds, speed / params.friction);
  }
  double after = std::max(0.0, speed - params.friction * time);
  double way = 0.5 * (speed + after) * time;
  if (k > kTiny) {
    const double decay = maths::exp(-k * time);
    after = std::max(0.0, (speed + floor) * decay - floor);
    way = (speed + floor) * (1.0 - decay) / k - floor * time;
  }
  const Point2<Field> direction = ball.velocity * (1.0 / speed);
  ball.position = ball.position + direction * way;
  ball.velocity = time < seconds ? Point2<Field>{} : direction * after;
}

void bounce(Ball& ball, const std::vector<Obstacle>& obstacles, const BallParams& params) {
  for (const Obstacle& obstacle : obstacles) {
    const Point2<Field> away = ball.position - nearestOn(obstacle, ball.position);
    const double reach = body::kBallRadius + obstacle.radius;
    const double gap = away.norm();
    if (gap >= reach) continue;
    const Point2<Field> n = gap > kTiny ? away * (1.0 / gap) : Point2<Field>{0.0, 1.0};
    apply(ball, {n, reach - gap, 0.0}, params.wallRestitution);
  }
}

void tickBall(Ball& ball, const std::vector<RobotModel>& robots,
              const std::vector<Obstacle>& obstacles, const BallParams& params) {
  constexpr double kNearby = 40.0;  // no part of a robot is further from its neck base
  for (int step = 1; step <= kSteps; ++step) {
    const double t = static_cast<double>(step) / kSteps;
    roll(ball, kTickSeconds / kSteps, params);
    for (const RobotModel& robot : robots) {
      if (distance(robot.place().pose.position, ball.position) > kNearby) continue;
      for (const BodySphere& sphere : robot.spheres()) touchSphere(ball, sphere, t, params);
      touchTrunk(ball, robot, t, params);
    }
    bounce(ball, obstacles, params);
    limitSpeed(ball, params);
  }
}

}  // namespace kelpie::sim
