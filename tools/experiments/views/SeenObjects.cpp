// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "tools/experiments/views/Objects.h"

namespace kelpie::experiments {
namespace {

// A percept farther than this from every object of its kind is false.
constexpr double kMatchHeadingDeg = 8.0;
constexpr double kMatchGoalDeg = 15.0;
constexpr double kMatchGoal = 40.0;  // cm, half a mouth: what is seen is within the goal
constexpr double kMatchRobotDeg = 15.0;
constexpr double kMatchShare = 0.4;         // of the distance
constexpr double kMinMatchDistance = 15.0;  // cm
constexpr double kMatchRobot = 25.0;        // cm, as long as a robot is

double headingLimit(ObjectKind kind, double distance) {
  if (kind == ObjectKind::goal)
    return std::fmax(kMatchGoalDeg, Angle::rad(std::atan2(kMatchGoal, distance)).deg());
  return kind == ObjectKind::robot ? kMatchRobotDeg : kMatchHeadingDeg;
}

}  // namespace

SeenObject seenObject(const BallPercept& b) {
  return {ObjectKind::ball, {}, {}, b.distance, b.heading};
}

SeenObject seenObject(const LandmarkPercept& l) {
  const bool goal = l.kind <= LandmarkKind::goalYellow;
  return {goal ? ObjectKind::goal : ObjectKind::beacon, l.kind, {}, l.distance, l.heading};
}

SeenObject seenObject(const RobotPercept& r) {
  return {ObjectKind::robot, {}, r.team, r.distance, r.heading};
}

std::vector<SeenObject> seenObjects(const Percepts& seen) {
  std::vector<SeenObject> all;
  if (seen.ball.present) all.push_back(seenObject(seen.ball));
  for (const auto& landmark : seen.landmarks) all.push_back(seenObject(landmark));
  for (const auto& robot : seen.robots) all.push_back(seenObject(robot));
  return all;
}

bool matches(const SeenObject& p, const TrueObject& o) {
  if (p.kind != o.kind || p.landmark != o.landmark || !o.inView) return false;
  const double minAllowed = p.kind == ObjectKind::robot ? kMatchRobot : kMinMatchDistance;
  const double allowed = std::fmax(kMatchShare * o.distance, minAllowed);
  return std::fabs((p.heading - o.heading).deg()) <= headingLimit(p.kind, o.distance) &&
         std::fabs(p.distance - o.distance) <= allowed;
}

}  // namespace kelpie::experiments
