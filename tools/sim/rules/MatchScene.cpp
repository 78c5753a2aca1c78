// SPDX-License-Identifier: Apache-2.0
#include "tools/sim/rules/MatchScene.h"

#include <algorithm>

namespace kelpie::sim {

Point2<Field> ownView(const body::FieldDescription& field, TeamColour team, Point2<Field> p) {
  if (team == TeamColour::red) return p;
  return {field.width - p.x, field.length - p.y};
}

Pose2 ownView(const body::FieldDescription& field, TeamColour team, const Pose2& pose) {
  if (team == TeamColour::red) return pose;
  return {ownView(field, team, pose.position), pose.heading + Angle::deg(180.0)};
}

Obstacle stripeOf(const Pose2& robot) {
  return {fieldFromRobot(robot, {0.0, kStripeRear}), fieldFromRobot(robot, {0.0, kStripeFront}),
          kStripeHalfWidth};
}

double stripeDistance(const Pose2& robot, Point2<Field> p) {
  return distance(nearestOn(stripeOf(robot), p), p);
}

// Of lines that do not cross, and bodies do not, the nearest points have an end among them.
double stripeDistance(const Pose2& one, const Pose2& other) {
  const Obstacle a = stripeOf(one);
  const Obstacle b = stripeOf(other);
  return std::min({distance(nearestOn(a, b.a), b.a), distance(nearestOn(a, b.b), b.b),
                   distance(nearestOn(b, a.a), a.a), distance(nearestOn(b, a.b), a.b)});
}

bool isFree(const MatchScene& scene, Point2<Field> place, double apart,
            std::optional<std::size_t> butFor) {
  for (std::size_t i = 0; i < scene.players.size(); ++i) {
    const ScenePlayer& player = scene.players[i];
    if (i == butFor || !player.playing) continue;
    if (distance(player.pose.position, place) < apart) return false;
  }
  return true;
}

}  // namespace kelpie::sim
