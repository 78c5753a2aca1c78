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
constexpr double kGravity = 981.0;
constexpr double kStep = 0.5;       // cm, of the search along a ray
constexpr double kSearch = 160.0;   // cm, how far rays are searched for upright things
constexpr double kChinReach = 2.5;  // cm between ball and jaw that closes the chin switch
constexpr double kPawGives = 0.2;   // cm that a paw is pushed in before its switch closes [chosen]
constexpr double kRobotReach = 40.0;   // cm: no part of a robot is further from its neck base
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
    const Point2<Field> middle = fieldFromRobot(around.robots[i].place().pose, {0.0, -6.5});
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
  const BodyPlace& place = around.robots[around.self].place();
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

bool chinTouched(const Surroundings& around, const BodySphere& head) {
  const BodyPlace& place = around.robots[around.self].place();
  const Point2<Robot> ball = robotFromField(place.pose, around.ball.position);
  const FieldPoint3 d =
      head.now - FieldPoint3{around.ball.position.x, around.ball.position.y, body::kBallRadius};
  const double gap = std::sqrt(d.x * d.x + d.y * d.y + d.z * d.z) - body::kBallRadius - head.radius;
  return d.z > 0.0 && gap < kChinReach && std::fabs(ball.x) < 5.0 && ball.y > 0.0;
}

bool within(FieldPoint3 a, FieldPoint3 b, double reach) {
  const FieldPoint3 d = a - b;
  return d.x * d.x + d.y * d.y + d.z * d.z < reach * reach;
}

// A part of a leg that is deeper inside something than its sole gives: it pushes.
bool pushes(const Surroundings& around, const BodySphere& part) {
  const double reach = part.radius - kPawGives;
  const Point2<Field> ground{part.now.x, part.now.y};
  for (const Obstacle& o : around.obstacles)
    if (distance(nearestOn(o, ground), ground) < o.radius + reach) return true;
  for (std::size_t i = 0; i < around.robots.size(); ++i) {
    const Point2<Field> other = around.robots[i].place().pose.position;
    if (i == around.self || distance(other, ground) > kRobotReach) continue;
    for (const BodySphere& theirs : around.robots[i].spheres())
      if (within(theirs.now, part.now, theirs.radius + reach)) return true;
  }
  return false;
}

// Whether a paw is pressed: by the ground that it stands on, or by what it or a front leg's lower
// part pushes into.
std::array<bool, kLegCount> pawsPressed(const Surroundings& around,
                                        const std::array<BodySphere, 9>& parts) {
  std::array<bool, kLegCount> pressed = around.robots[around.self].onGround();
  for (std::size_t i = 0; i < kLegCount; ++i) pressed[i] = pressed[i] || pushes(around, parts[i]);
  const std::size_t left = index(LegId::leftFront);
  const std::size_t right = index(LegId::rightFront);
  pressed[left] = pressed[left] || pushes(around, parts[kLeftShin]);
  pressed[right] = pressed[right] || pushes(around, parts[kRightShin]);
  return pressed;
}

}  // namespace

std::array<double, 3> accelerationAtRest(const Stance& stance, const BodyFaults& faults) {
  const Angle tilt = stance.bodyTilt + faults.lean.tilt;
  const Angle roll = faults.lean.roll;
  const std::array<double, 3>& bias = faults.accelerationBias;
  return {-kGravity * tilt.sin() * roll.cos() + bias[0], kGravity * roll.sin() + bias[1],
          kGravity * tilt.cos() * roll.cos() + bias[2]};
}

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

SensorFrame sense(const Surroundings& around, const SensorParams& params, Random& random) {
  const RobotModel& robot = around.robots[around.self];
  SensorFrame frame;
  frame.joints = robot.sensed();
  for (std::size_t j = 0; j < kJointCount; ++j) {
    const double error = robot.target().angle[j].rad() - robot.motors().angle[j].rad();
    const bool leg = j >= index(Joint::leftFrontRotator) && j <= index(Joint::rightHindKnee);
    const double gain = params.dutyPerRad * (leg ? robot.legGain() : 1.0);
    frame.duty[j] = maths::clamp(gain * error + robot.dutyNoise()[j], -1.0, 1.0);
  }
  senseDistances(around, params.distanceNoise, random, frame);
  frame.acceleration = accelerationAtRest(robot.place().stance, robot.faults());
  for (double& axis : frame.acceleration) axis = random.gaussian(axis, params.accelerationSd);
  const auto parts = robot.spheres();
  frame.paw = pawsPressed(around, parts);
  const Touch touch = robot.touched();
  frame.chin = touch.chin || chinTouched(around, parts.back());
  frame.headTouch = touch.head;
  frame.back = touch.back;
  return frame;
}

}  // namespace kelpie::sim
