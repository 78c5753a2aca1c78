// SPDX-License-Identifier: Apache-2.0
#include "tools/sim/Sensors.h"

#include <algorithm>
#include <cmath>

#include "tools/sim/FieldCamera.h"

namespace kelpie::sim {
namespace {

constexpr double kNothing = 1e6;
constexpr double kObstacleHeight = 30.0;
constexpr double kRobotHeight = 20.0;
constexpr double kRobotRadius = 8.0;
constexpr double kStep = 0.5;          // cm, of the search along a ray
constexpr double kSearch = 160.0;      // cm, how far rays are searched for upright things
constexpr double kChestHeight = -2.0;  // of the chest sensor over the shoulder axis
constexpr double kChestDown = 0.5;     // slope of the chest sensor's ray

FieldPoint3 along(FieldPoint3 from, FieldPoint3 way, double t) {
  return {from.x + t * way.x, from.y + t * way.y, from.z + t * way.z};
}

double groundAlong(FieldPoint3 from, FieldPoint3 way) {
  return way.z < -1e-6 ? -from.z / way.z : kNothing;
}

double ballAlong(const Ball& ball, FieldPoint3 from, FieldPoint3 way) {
  const FieldPoint3 d{ball.position.x - from.x, ball.position.y - from.y,
                      body::kBallRadius - from.z};
  const double middle = d.x * way.x + d.y * way.y + d.z * way.z;
  const double miss2 = d.x * d.x + d.y * d.y + d.z * d.z - middle * middle;
  const double r2 = body::kBallRadius * body::kBallRadius;
  if (miss2 >= r2 || middle <= 0.0) return kNothing;
  return std::max(0.0, middle - std::sqrt(r2 - miss2));
}

bool insideAnything(const Surroundings& around, FieldPoint3 p) {
  const Point2<Field> ground{p.x, p.y};
  if (p.z < kObstacleHeight) {
    for (const Obstacle& o : around.obstacles) {
      if (distance(nearestOn(o, ground), ground) < o.radius) return true;
    }
  }
  if (p.z > kRobotHeight) return false;
  for (std::size_t i = 0; i < around.robots.size(); ++i) {
    if (i == around.self) continue;
    const Point2<Field> middle = fieldFromRobot(around.robots[i].pose, {0.0, -6.5});
    if (distance(middle, ground) < kRobotRadius) return true;
  }
  return false;
}

double uprightAlong(const Surroundings& around, FieldPoint3 from, FieldPoint3 way, double limit) {
  const double end = std::min(limit, kSearch);
  for (double t = 0.0; t < end; t += kStep) {
    if (insideAnything(around, along(from, way, t))) return t;
  }
  return kNothing;
}

struct Range {
  double low;
  double high;
};
double measured(double distance, Range range, double noise, Random& random) {
  const double value = std::min(distance, 2.0 * range.high) * (1.0 + noise * random.gaussian());
  return maths::clamp(value, range.low, range.high);
}

void senseDistances(const Surroundings& around, double noise, Random& random, SensorFrame& frame) {
  const BodyPlace& place = around.robots[around.self];
  const FieldCamera head = fieldCamera(place.pose, trueCamera(place));
  const double ahead = rayDistance(around, head.position, head.forward);
  frame.headNearDistance = measured(ahead, {5.0, 50.0}, noise, random);
  frame.headFarDistance = measured(ahead, {20.0, 150.0}, noise, random);
  const Point3<Robot> chest =
      leanedPoint(place, {0.0, kChestAhead, place.stance.shoulderHeight + kChestHeight});
  const Point2<Field> over = fieldFromRobot(place.pose, {chest.x, chest.y});
  const double c = 1.0 / std::sqrt(1.0 + kChestDown * kChestDown);
  const FieldPoint3 way =
      fieldVector(place.pose, leanedVector(place.lean, {0.0, c, -c * kChestDown}));
  const double down = rayDistance(around, {over.x, over.y, chest.z}, way);
  frame.chestDistance = measured(down, {10.0, 90.0}, noise, random);
}

}  // namespace

double rayDistance(const Surroundings& around, FieldPoint3 from, FieldPoint3 direction) {
  const double free =
      std::min(groundAlong(from, direction), ballAlong(around.ball, from, direction));
  return std::min(free, uprightAlong(around, from, direction, free));
}

double batteryCurrent(const std::array<SensorFrame, kTicksPerMessage>& ticks,
                      const SensorParams& params) {
  double duty = 0.0;
  for (const SensorFrame& tick : ticks)
    for (std::size_t j = index(Joint::leftFrontRotator); j <= index(Joint::rightHindKnee); ++j)
      duty += std::fabs(tick.duty[j]) / kTicksPerMessage;
  return params.idleCurrent + params.currentPerDuty * duty;
}

SensorFrame sense(const Surroundings& around, const BodyFeeling& feeling,
                  const SensorParams& params, Random& random) {
  SensorFrame frame;
  frame.joints = feeling.joints;
  frame.duty = feeling.duty;
  senseDistances(around, params.distanceNoise, random, frame);
  frame.acceleration = feeling.acceleration;
  for (double& axis : frame.acceleration) axis = random.gaussian(axis, params.accelerationSd);
  frame.paw = feeling.paw;
  frame.chin = feeling.touch.chin;
  frame.headTouch = feeling.touch.head;
  frame.back = feeling.touch.back;
  return frame;
}

}  // namespace kelpie::sim
