// SPDX-License-Identifier: Apache-2.0
#include "tools/sim/bodies/Sensors.h"

#include <algorithm>
#include <cmath>

#include "robot/body/Legs.h"
#include "tools/sim/camera/FieldCamera.h"

namespace kelpie::sim {
namespace {

constexpr double kNothing = 1e6;
constexpr double kObstacleHeight = 30.0;
constexpr double kRobotHeight = 20.0;
constexpr double kRobotRadius = 8.0;
constexpr double kStep = 0.5;      // cm, of the search along a ray
constexpr double kSearch = 160.0;  // cm, how far rays are searched for upright things
// The chest sensor in the torso: below and ahead of the front shoulder axis, its ray 30 deg below
// the trunk's axis. With a held ball it is 2 cm from it, without one 8 (physics.md section 10: 1.5
// to 2.2, 7 to 7.5).
constexpr double kChestSensorAhead = 3.0;  // cm
constexpr double kChestSensorAbove = -2.0;
constexpr double kChestRayDown = 30.0;  // deg
// Closer than this a triangulating sensor sees ever less of its own spot, which reads as further
// away: at half of it as at twice of it [chosen; facts-2005 section 6.4 takes 13 cm for a held
// ball].
constexpr double kChestFolds = 7.0;  // cm

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

// Whether a ray's first `end` cm can come that close to it, seen from above.
bool mayMeet(const Obstacle& thing, FieldPoint3 from, FieldPoint3 way, double end) {
  const Point2<Field> middle = (thing.a + thing.b) * 0.5;
  const Point2<Field> d{middle.x - from.x, middle.y - from.y};
  const double reach = thing.radius + 0.5 * distance(thing.a, thing.b);
  if (maths::square(d.x) + maths::square(d.y) > maths::square(reach + end)) return false;
  return std::fabs(d.x * way.y - d.y * way.x) <= reach * maths::hypot(way.x, way.y) + 1e-9;
}

// How far along a ray a thing of that height is met; `end` when it is not before that.
double thingAlong(const Obstacle& thing, double height, FieldPoint3 from, FieldPoint3 way,
                  double end) {
  if (!mayMeet(thing, from, way, end)) return end;
  for (double t = 0.0; t < end; t += kStep) {
    const FieldPoint3 p = along(from, way, t);
    if (p.z >= height) continue;
    const Point2<Field> ground{p.x, p.y};
    if (distance(nearestOn(thing, ground), ground) < thing.radius) return t;
  }
  return end;
}

double uprightAlong(const Surroundings& around, FieldPoint3 from, FieldPoint3 way, double limit) {
  const double end = std::min(limit, kSearch);
  double first = end;
  for (const Obstacle& thing : around.obstacles)
    first = thingAlong(thing, kObstacleHeight, from, way, first);
  for (std::size_t i = 0; i < around.robots.size(); ++i) {
    if (i == around.self) continue;
    const Point2<Field> middle = fieldFromRobot(around.robots[i].pose, {0.0, -6.5});
    first = thingAlong({middle, middle, kRobotRadius}, kRobotHeight, from, way, first);
  }
  return first < end ? first : kNothing;
}

struct Range {
  double low;
  double high;
};
double measured(double distance, Range range, double noise, Random& random) {
  const double value = std::min(distance, 2.0 * range.high) * (1.0 + noise * random.gaussian());
  return maths::clamp(value, range.low, range.high);
}

void senseDistances(const Surroundings& around, double noise, const NoseSensor& nose,
                    Random& random, SensorFrame& frame) {
  const BodyPlace& place = around.robots[around.self];
  const FieldCamera head = fieldCamera(place.pose, trueCamera(place));
  const double ahead = rayDistance(around, head.position, head.forward);
  frame.headNearDistance = measured(nose.gain * ahead + nose.offset, {5.0, 50.0}, noise, random);
  frame.headFarDistance = measured(ahead, {20.0, 150.0}, noise, random);
  frame.chestDistance = chestDistance(around, noise, random);
}

}  // namespace

double chestDistance(const Surroundings& around, double noise, Random& random) {
  const BodyPlace& place = around.robots[around.self];
  const Point3<Robot> sensor = leanedPoint(
      place, body::robotFromTorso(place.stance, {0.0, kChestSensorAhead, kChestSensorAbove}));
  const Point2<Field> over = fieldFromRobot(place.pose, {sensor.x, sensor.y});
  const maths::SinCos down =
      maths::sinCos((place.stance.bodyTilt + Angle::deg(kChestRayDown)).rad());
  const FieldPoint3 way =
      fieldVector(place.pose, leanedVector(place.lean, {0.0, down.cos, -down.sin}));
  const double real = rayDistance(around, {over.x, over.y, sensor.z}, way);
  const double seen = real < kChestFolds ? kChestFolds * kChestFolds / std::fmax(real, 0.1) : real;
  return measured(seen, {10.0, 90.0}, noise, random);
}

double rayDistance(const Surroundings& around, FieldPoint3 from, FieldPoint3 direction) {
  const double free =
      std::min(groundAlong(from, direction), ballAlong(around.ball, from, direction));
  return std::min(free, uprightAlong(around, from, direction, free));
}

double batteryCurrent(const std::array<SensorFrame, kTicksPerMessage>& ticks,
                      const SensorParams& params, bool physical) {
  double duty = 0.0;
  double squares = 0.0;
  for (const SensorFrame& tick : ticks)
    for (std::size_t j = index(Joint::leftFrontRotator); j <= index(Joint::rightHindKnee); ++j) {
      duty += std::fabs(tick.duty[j]) / kTicksPerMessage;
      squares += maths::square(tick.duty[j]) / kTicksPerMessage;
    }
  if (physical) return params.idleCurrent + params.currentPerSquare * squares;
  return params.idleCurrent + params.currentPerDuty * duty;
}

double drained(double charge, double current, double seconds, const SensorParams& params) {
  constexpr double kHour = 3600.0;  // s
  return std::max(0.0, charge - current * seconds / (kHour * params.capacity));
}

SensorFrame sense(const Surroundings& around, const BodyFeeling& feeling,
                  const SensorParams& params, Random& random, const NoseSensor& nose) {
  SensorFrame frame;
  frame.joints = feeling.joints;
  frame.duty = feeling.duty;
  senseDistances(around, params.distanceNoise, nose, random, frame);
  frame.acceleration = feeling.acceleration;
  for (double& axis : frame.acceleration) axis = random.gaussian(axis, params.accelerationSd);
  frame.paw = feeling.paw;
  frame.chin = feeling.touch.chin;
  frame.headTouch = feeling.touch.head;
  frame.back = feeling.touch.back;
  return frame;
}

}  // namespace kelpie::sim
