// SPDX-License-Identifier: Apache-2.0
#include "vision/ball/BallFacts.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "robot/core/Maths.h"
#include "vision/LogOdds.h"

namespace kelpie::vision {
namespace {

// The rms of edges that are whole pixels, as in class planes, says nothing about a ball.
constexpr double kWholePixels = 0.4;
constexpr double kMaxRadii = 4.0;
constexpr double kMaxFoot = 30.0;  // px
// Points outside the image count as carpet below this row: half the image.
constexpr double kCarpetFromRow = 80.0;
constexpr double kBlur = 2.0;   // px beyond the outline in which colours are mixed
constexpr int kFieldSteps = 6;  // of 30 deg along the lower half: seven points

// Shares of the circle, on a grid of at most about 150 points.
void fillInside(const Scene& scene, const Cone& cone, BallFacts& facts) {
  constexpr double kMaxGridRadius = 200.0;  // px
  constexpr double kPointsPerRadius = 7.0;
  std::array<int, kColourClassCount> count{};
  int all = 0;
  const double r = std::min(cone.radius, kMaxGridRadius);
  const double step = std::max(1.0, r / kPointsPerRadius);
  for (double y = -r; y <= r; y += step) {
    for (double x = -r; x <= r; x += step) {
      const PixelPoint p{cone.centre.x + x, cone.centre.y + y};
      if (x * x + y * y > r * r || !Sampler::usable(p)) continue;
      ++count[index(scene.sampler.classAt(p))];
      ++all;
    }
  }
  const auto share = [&](ColourClass c) {
    return count[index(c)] / std::max(1.0, static_cast<double>(all));
  };
  // A sliver at the border may show no point of the circle's grid: nothing is against it.
  facts.orange = all > 0 ? share(ColourClass::orange) : 1.0;
  facts.otherColour =
      share(ColourClass::pink) + share(ColourClass::yellow) + share(ColourClass::robotRed);
  facts.green = share(ColourClass::green);
}

// A point of a circle around the ball's, seen level: to the right at 0, below at a quarter turn.
PixelPoint around(const Scene& scene, const BallCandidate& c, double radius, double turn) {
  const auto direction = maths::sinCos(turn);
  const LevelPoint middle = scene.frame.fromImage(c.cone.centre);
  return scene.frame.toImage(
      {middle.u + radius * direction.cos, middle.v + radius * direction.sin});
}

double orangeBeside(const Scene& scene, const BallCandidate& c) {
  constexpr int kPoints = 12;
  constexpr double kRing = 1.25;  // radii
  int seen = 0;
  int orange = 0;
  for (int i = 0; i < kPoints; ++i) {
    const PixelPoint at =
        around(scene, c, kRing * c.cone.radius + kBlur, 2.0 * maths::kPi * i / kPoints);
    if (!Sampler::usable(at)) continue;
    ++seen;
    orange += scene.sampler.classAt(at) == ColourClass::orange ? 1 : 0;
  }
  return seen > 0 ? static_cast<double>(orange) / seen : 0.0;
}

double fieldAround(const Scene& scene, const BallCandidate& c) {
  constexpr double kRing = 1.3;  // radii
  int field = 0;
  for (int i = 0; i <= kFieldSteps; ++i) {
    const PixelPoint at =
        around(scene, c, kRing * c.cone.radius + kBlur, maths::kPi * i / kFieldSteps);
    const bool green = Sampler::usable(at) ? scene.sampler.classAt(at) == ColourClass::green
                                           : at.y > kCarpetFromRow;
    field += green ? 1 : 0;
  }
  return field / (kFieldSteps + 1.0);
}

// A ball hides its goal's foot: right behind its shadow is carpet. Orange over a goal's wall is
// seen over it, on its colour. The shadow of a large ball may look blue, so there the wall must
// show farther down.
double goalBelow(const Scene& scene, const BallCandidate& c) {
  constexpr double kLargeRadius = 8.0;                      // px
  constexpr double kBelowSmall = 2.5;                       // px below the outline
  constexpr double kBelowLarge = 1.6;                       // radii below the centre
  constexpr std::array<double, 3> kFurther{0.0, 0.7, 1.5};  // radii
  const double start = c.cone.radius < kLargeRadius ? c.cone.radius + kBelowSmall
                                                    : kBelowLarge * c.cone.radius + kBlur;
  int goal = 0;
  for (const double further : kFurther) {
    const double down = start + further * std::min(c.cone.radius, kLargeRadius);
    const PixelPoint at = around(scene, c, down, 0.5 * maths::kPi);
    if (!Sampler::usable(at)) break;
    const ColourClass colour = scene.sampler.classAt(at);
    goal += colour == ColourClass::blue || colour == ColourClass::yellow ? 1 : 0;
  }
  return goal / static_cast<double>(kFurther.size());
}

double logOfPatch(const BallCandidate& c) {
  const double patch = static_cast<double>(c.blob->samples) * kLatticeStep * kLatticeStep;
  const double circle = maths::kPi * c.cone.radius * c.cone.radius;
  return logOfRatio(patch / std::max(circle, 1.0));
}

}  // namespace

BallFacts ballFacts(const Scene& scene, const BallCandidate& c) {
  BallFacts facts;
  const double radius = std::max(c.cone.radius, 1.0);
  facts.range = c.range;
  facts.radius = c.cone.radius;
  facts.edges = static_cast<double>(c.cone.kept);
  facts.cut = static_cast<double>(c.cut);
  facts.circleError = std::max(0.0, c.cone.rms - kWholePixels) / radius;
  fillInside(scene, c.cone, facts);
  facts.patch = logOfPatch(c);
  facts.beside = orangeBeside(scene, c);
  facts.goalBelow = goalBelow(scene, c);
  facts.carpetAround = fieldAround(scene, c);
  const double shared = ballElevationError(scene, c) - settledBallElevationError(scene, c);
  facts.belowHorizon = belowHorizon(scene, c.cone.centre) + focalLength(scene) * shared;
  facts.edgeShows = flag(!scene.fieldEdges.empty());
  if (!scene.fieldEdges.empty()) {
    const double below = belowFieldEdge(scene, c.cone.centre) + c.cone.radius;
    facts.footBelowEdge = maths::clamp(below, -kMaxFoot, kMaxFoot);
    facts.footBelowInRadii = maths::clamp(below / radius, -kMaxRadii, kMaxRadii);
  }
  facts.heightError = ballHeightError(scene, c);
  facts.standsAlone = flag(c.standsAlone);
  return facts;
}

}  // namespace kelpie::vision
