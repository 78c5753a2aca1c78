// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <cmath>

#include "robot/body/Camera.h"
#include "tools/percepts/Eye.h"
#include "tools/percepts/Shown.h"

namespace kelpie::percepts {
namespace {

constexpr double kEdgeSd = 0.3;     // px of the radius, as vision says of it
constexpr double kHeadingSd = 0.7;  // deg, so

// Share of the disc that is in the image and hidden by nobody.
double shareOf(const View& view, const Spot& centre, double radius) {
  constexpr std::array<PixelPoint, 9> kParts{{{0.0, 0.0},
                                              {0.8, 0.0},
                                              {-0.8, 0.0},
                                              {0.0, 0.8},
                                              {0.0, -0.8},
                                              {0.5, 0.5},
                                              {-0.5, 0.5},
                                              {0.5, -0.5},
                                              {-0.5, -0.5}}};
  int shown = 0;
  for (const PixelPoint& part : kParts)
    if (view.shows(
            {{centre.pixel.x + radius * part.x, centre.pixel.y + radius * part.y}, centre.depth}))
      ++shown;
  return static_cast<double>(shown) / kParts.size();
}

constexpr double kNear = 150.0;  // cm, between which and
constexpr double kFar = 300.0;   // things get harder
constexpr double kTurns = 0.05;  // rad a frame: the head turns

double farness(double along) { return maths::clamp((along - kNear) / (kFar - kNear), 0.0, 1.0); }

double recallAt(const BallErrors& errors, const ShownBall& shown) {
  const double far = farness(shown.along);
  const double fades =
      maths::clamp((errors.farthest - shown.along) / (errors.farthest - errors.fades), 0.0, 1.0);
  return fades * ((1.0 - far) * recallOf(errors.near, shown.share) +
                  far * recallOf(errors.far, shown.share));
}

// The distance that it seems to have.
double seenAlongOf(const Look& look, const ShownBall& shown) {
  const BallErrors& errors = look.noise.ball;
  const bool whole = shown.share >= 1.0;
  const double bias = errors.bias + errors.farBias * (whole ? farness(shown.along) : 1.0);
  const double sd = !whole                         ? errors.partShare
                    : look.body.headSpeed > kTurns ? errors.turningShare
                                                   : errors.share;
  return shown.along * maths::clamp(look.random.gaussian(1.0 + bias, sd), 0.5, 2.0);
}

}  // namespace

std::optional<ShownBall> shownBall(const View& view, Point2<Field> ball) {
  const auto centre = view.spot({ball.x, ball.y, body::kBallRadius});
  if (!centre) return std::nullopt;
  ShownBall shown;
  shown.centre = *centre;
  shown.along = view.distance(ball);
  shown.range = std::hypot(shown.along, body::kBallRadius - view.eye().position.z);
  shown.radius = view.eye().lens.focal * body::kBallRadius / shown.range;
  shown.share = shareOf(view, *centre, shown.radius);
  return shown;
}

void seeBall(const Look& look, BallPercept& ball) {
  const BallErrors& errors = look.noise.ball;
  const auto shown = shownBall(look.view, look.moment.ball);
  if (!shown || !look.random.chance(recallAt(errors, *shown))) return;
  const PixelPoint pixel{shown->centre.pixel.x + look.random.gaussian(0.0, errors.pixel),
                         shown->centre.pixel.y + look.random.gaussian(0.0, errors.pixel)};
  const double seenAlong = seenAlongOf(look, *shown);
  const CameraPose& camera = look.view.believed();
  const Point2<Robot> place = readPlace(camera, pixel, seenAlong);
  const double pixelAngle = kEdgeSd / camera.lens.focalLength;
  ball.present = true;
  ball.distance = place.norm();
  ball.heading = bearing(place);
  ball.elevation = Angle::rad(maths::atan(readSlope(camera, pixel)));
  ball.distanceVariance = maths::square(seenAlong * kEdgeSd / shown->radius);
  ball.headingVariance = maths::square(Angle::deg(kHeadingSd).rad()) + pixelAngle * pixelAngle;
  ball.centre = pixel;
  ball.radius = shown->radius;
  const double below = (camera.position.z - body::kBallRadius) / shown->range;
  if (shown->share >= 1.0 && below < 0.8)
    ball.elevationError = elevationErrorAt(
        look, pixel, body::kBallRadius, seenAlong,
        maths::square(2.0 * below * kEdgeSd / shown->radius) + pixelAngle * pixelAngle);
}

}  // namespace kelpie::percepts
