// SPDX-License-Identifier: Apache-2.0
#include "vision/goal/GoalPlace.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "robot/body/Camera.h"
#include "vision/ElevationDoubt.h"

namespace kelpie::vision {
namespace {

using Vec = Point2<Robot>;

constexpr double kMaxEdgeDistance = 200.0;  // cm; an edge at the horizon is thousands away

double dot(Vec a, Vec b) { return a.x * b.x + a.y * b.y; }

// A line on the ground relative to the camera: the unit vector towards it, and its distance in cm.
struct GroundLine {
  Vec normal;
  double distance = 0.0;
};

std::optional<GroundLine> groundLine(const Scene& scene, const FieldEdgePercept& e) {
  constexpr double kLeft = 0.25;  // of the image's width
  constexpr double kRight = 0.75;
  const CameraPose& camera = scene.body.camera;
  const auto at = [&](double x) { return body::groundPoint(camera, {x, edgeRow(e, x)}); };
  const auto left = at(kLeft * kImageWidth);
  const auto right = at(kRight * kImageWidth);
  if (!left || !right) return std::nullopt;
  const Vec along = *right - *left;
  const double length = along.norm();
  if (length < 1.0) return std::nullopt;
  const Vec normal{-along.y / length, along.x / length};
  const double distance = dot(normal, *left - Vec{camera.position.x, camera.position.y});
  return distance >= 0.0 ? GroundLine{normal, distance} : GroundLine{normal * -1.0, -distance};
}

// The line's distance with no more of a difference in elevation from where it is expected than
// would count in settled play (ElevationDoubt.h).
double settledDistance(const Scene& scene, const GroundLine& line, double expected) {
  const CameraPose& camera = scene.body.camera;
  constexpr double kNearest = 1.0;  // cm; behind the camera no tilt brings it
  const ElevationDoubt doubt = elevationDoubt(camera, {line.normal.x, line.normal.y, 0.0});
  if (doubt.sd == 0.0 || expected < kNearest) return line.distance;
  const double slope = camera.position.z / expected;
  const double seen = camera.position.z / std::max(line.distance, kNearest);
  return camera.position.z / (slope + (seen - slope) / doubt.spread);
}

// The edge below the goal, which counts as the one that it stands on.
const FieldEdgePercept* edgeBelow(const Scene& scene, const GoalCandidate& c) {
  const double x = scene.frame.toImage({c.box.middle(), c.box.bottom}).x;
  const FieldEdgePercept* lowest = nullptr;
  for (const FieldEdgePercept& e : scene.fieldEdges)
    if (lowest == nullptr || edgeRow(e, x) > edgeRow(*lowest, x)) lowest = &e;
  return lowest;
}

void addEdgeFacts(const Scene& scene, const GoalCandidate& c, const GoalShape& shape,
                  GoalFacts& facts) {
  const body::FieldDescription& f = scene.field;
  const double halfCarpet = 0.5 * f.width + f.sideFringe - f.borderWidth;
  const FieldEdgePercept* below = edgeBelow(scene, c);
  if (below == nullptr) return;
  for (const FieldEdgePercept& e : scene.fieldEdges) {
    const auto line = groundLine(scene, e);
    if (!line) continue;
    const double ahead = dot(line->normal, shape.middle);
    if (&e != below) {
      const double expected = ahead + halfCarpet;
      const double off = std::fabs(settledDistance(scene, *line, expected) - expected);
      facts.cornerError = std::max(facts.cornerError, off);
      continue;
    }
    const double expected = ahead + scene.field.goalDepth;
    facts.edgeDistance = maths::clamp(settledDistance(scene, *line, expected) - expected,
                                      -kMaxEdgeDistance, kMaxEdgeDistance);
    facts.edgeLateralOffset = std::fabs(dot({line->normal.y, -line->normal.x}, shape.middle));
    const Vec mouth{maths::cos(shape.turn), maths::sin(shape.turn)};
    facts.edgeTurn = std::fabs(Angle::rad(maths::asin(dot(line->normal, mouth))).deg());
  }
}

// Goal and beacon together place the camera.
void addBeaconFacts(const Scene& scene, LandmarkKind kind, const GoalShape& shape,
                    const LandmarkPercept& beacon, GoalFacts& facts) {
  const body::Landmark* goal = body::findLandmark(scene.field.landmarks, kind);
  const body::Landmark* known = body::findLandmark(scene.field.landmarks, beacon.kind);
  if (goal == nullptr || known == nullptr) return;
  const Point3<Robot>& eye = scene.body.camera.position;
  const Vec seen = robotPolar(beacon.distance, beacon.heading) - Vec{eye.x, eye.y} - shape.middle;
  const Point2<Field> way = known->position - goal->position;
  facts.beaconError = std::max(facts.beaconError, std::fabs(seen.norm() - way.norm()));
  const maths::SinCos turn =
      maths::sinCos(maths::atan2(way.y, way.x) - maths::atan2(seen.y, seen.x));
  const Vec g = shape.middle;
  const Point2<Field> camera{goal->position.x - (turn.cos * g.x - turn.sin * g.y),
                             goal->position.y - (turn.sin * g.x + turn.cos * g.y)};
  facts.offCarpetDistance =
      std::max(facts.offCarpetDistance, body::carpetDistance(scene.field, camera));
}

}  // namespace

void addPlace(const Scene& scene, const GoalCandidate& c, const GoalShape& shape,
              const Landmarks& beacons, GoalFacts& facts) {
  addEdgeFacts(scene, c, shape, facts);
  for (const LandmarkPercept& beacon : beacons)
    addBeaconFacts(scene, goalKind(c.colour), shape, beacon, facts);
}

}  // namespace kelpie::vision
