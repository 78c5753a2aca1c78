// SPDX-License-Identifier: Apache-2.0
#include "tools/sim/rules/ThrowIn.h"

#include <cmath>

namespace kelpie::sim {
namespace {

// A ball that is put down is not put into a robot: stripe, half of its width, ball, and 2 cm.
constexpr double kClear = kStripeHalfWidth + body::kBallRadius + 2.0;
constexpr double kStep = 10.0;  // cm along the throw-in line

bool isClear(const MatchScene& scene, Point2<Field> place) {
  for (const ScenePlayer& player : scene.players)
    if (player.playing && stripeDistance(player.pose, place) < kClear) return false;
  return true;
}

// Towards the half-way line and beyond; eight robots cover 8 x 45 of the 340 cm at most, and if
// they do the ball lies where it should.
Point2<Field> cleared(const body::FieldDescription& field, const MatchScene& scene,
                      Point2<Field> place) {
  const double way = place.y < 0.5 * field.length ? kStep : -kStep;
  for (double gone = 0.0; gone < 0.6 * field.length; gone += kStep) {
    const Point2<Field> tried{place.x, place.y + way * gone / kStep};
    if (isClear(scene, tried)) return tried;
  }
  return place;
}

}  // namespace

std::optional<TeamColour> goalFor(const body::FieldDescription& field, Point2<Field> ball) {
  if (std::fabs(ball.x - field.width / 2.0) > field.goalWidth / 2.0) return std::nullopt;
  if (ball.y < -body::kBallRadius) return TeamColour::blue;
  if (ball.y > field.length + body::kBallRadius) return TeamColour::red;
  return std::nullopt;
}

bool ballOut(const body::FieldDescription& field, Point2<Field> ball) {
  if (goalFor(field, ball)) return false;
  const double r = body::kBallRadius;
  return ball.x < -r || ball.x > field.width + r || ball.y < -r || ball.y > field.length + r;
}

const char* outOver(const body::FieldDescription& field, Point2<Field> ball) {
  const double r = body::kBallRadius;
  const bool side = ball.x < -r || ball.x > field.width + r;
  const bool end = ball.y < -r || ball.y > field.length + r;
  if (side && end) return "over the corner";
  return side ? "over the side line" : "over the goal line";
}

Point2<Field> throwIn(const body::FieldDescription& field, const MatchScene& scene) {
  return cleared(field, scene, body::throwInPlace(field, scene.ball.position));
}

Point2<Field> dropIn(const body::FieldDescription& field, const MatchScene& scene) {
  Point2<Field> place = body::throwInPlace(field, scene.ball.position);
  if (distance(place, scene.ball.position) < field.rules.stuckDistance)
    place.x = field.width - place.x;
  return cleared(field, scene, place);
}

}  // namespace kelpie::sim
