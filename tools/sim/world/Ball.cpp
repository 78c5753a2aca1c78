// SPDX-License-Identifier: Apache-2.0
#include "tools/sim/world/Ball.h"

#include <algorithm>
#include <cmath>

namespace kelpie::sim {
namespace {

constexpr double kWallHalf = 0.6;  // cm, half the thickness of a goal's wall
constexpr double kPostRadius = 1.0;
constexpr double kTiny = 1e-9;

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

void strike(Ball& ball, const Impact& impact, double restitution) {
  ball.position = ball.position + impact.normal * impact.depth;
  const double closing =
      impact.speed - (ball.velocity.x * impact.normal.x + ball.velocity.y * impact.normal.y);
  if (closing > 0.0) {
    ball.velocity = ball.velocity + impact.normal * ((1.0 + restitution) * closing);
  }
}

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
    strike(ball, {n, reach - gap, 0.0}, params.wallRestitution);
  }
}

}  // namespace kelpie::sim
