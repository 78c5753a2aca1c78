// SPDX-License-Identifier: Apache-2.0
#include "vision/GoalPlace.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "robot/body/Camera.h"

namespace kelpie::vision {
namespace {

using Vec = Point2<Robot>;

constexpr double kFar = 200.0;  // cm; an edge at the horizon is thousands away

double dot(Vec a, Vec b) { return a.x * b.x + a.y * b.y; }

// A line on the ground relative to the camera: unit vector towards it, and how far.
struct GroundLine {
  Vec normal;
  double away = 0.0;
};

std::optional<GroundLine> groundLine(const Scene& scene, const FieldEdgePercept& e) {
  const CameraPose& camera = scene.body.camera;
  const auto at = [&](double x) { return body::groundPoint(camera, {x, edgeRow(e, x)}); };
  const auto left = at(0.25 * kImageWidth);
  const auto right = at(0.75 * kImageWidth);
  if (!left || !right) return std::nullopt;
  const Vec along = *right - *left;
  const double length = along.norm();
  if (length < 1.0) return std::nullopt;
  const Vec normal{-along.y / length, along.x / length};
  const double away = dot(normal, *left - Vec{camera.position.x, camera.position.y});
  return away >= 0.0 ? GroundLine{normal, away} : GroundLine{normal * -1.0, -away};
}

// The edge below the goal, which counts as the one that it stands on.
const FieldEdgePercept* edgeBelow(const Scene& scene, const GoalCandidate& c) {
  const double x = scene.level.toImage({c.box.middle(), c.box.bottom}).x;
  const FieldEdgePercept* lowest = nullptr;
  for (const FieldEdgePercept& e : scene.fieldEdges)
    if (lowest == nullptr || edgeRow(e, x) > edgeRow(*lowest, x)) lowest = &e;
  return lowest;
}

void judgeEdges(const Scene& scene, const GoalCandidate& c, const GoalShape& shape,
                const GoalParams& p, GoalFacts& facts) {
  const body::FieldDescription& f = scene.field;
  const double halfCarpet = 0.5 * f.width + f.sideFringe - f.borderWidth;
  const FieldEdgePercept* below = edgeBelow(scene, c);
  if (below == nullptr) return;
  for (const FieldEdgePercept& e : scene.fieldEdges) {
    const auto line = groundLine(scene, e);
    if (!line) continue;
    const double ahead = dot(line->normal, shape.middle);
    if (&e != below) {
      const double off = std::fabs(line->away - ahead - halfCarpet);
      facts.cornerOff = std::max(facts.cornerOff, off);
      continue;
    }
    facts.fromEdge = maths::clamp(line->away - ahead - p.depth, -kFar, kFar);
    facts.edgeAside = std::fabs(dot({line->normal.y, -line->normal.x}, shape.middle));
    const Vec mouth{maths::cos(shape.turn), maths::sin(shape.turn)};
    facts.edgeTurn = std::fabs(Angle::rad(maths::asin(dot(line->normal, mouth))).deg());
  }
}

// cm outside the carpet.
double outsideOf(const body::FieldDescription& f, Point2<Field> p) {
  return std::max({-f.sideFringe - p.x, p.x - f.width - f.sideFringe, -f.endFringe - p.y,
                   p.y - f.length - f.endFringe, 0.0});
}

// Goal and beacon together place the camera.
void judgeBeacon(const Scene& scene, LandmarkKind kind, const GoalShape& shape,
                 const LandmarkPercept& beacon, GoalFacts& facts) {
  const body::Landmark* goal = body::findLandmark(scene.field.landmarks, kind);
  const body::Landmark* known = body::findLandmark(scene.field.landmarks, beacon.kind);
  if (goal == nullptr || known == nullptr) return;
  const Point3<Robot>& eye = scene.body.camera.position;
  const Vec seen = robotPolar(beacon.distance, beacon.heading) - Vec{eye.x, eye.y} - shape.middle;
  const Point2<Field> way = known->position - goal->position;
  facts.beaconOff = std::max(facts.beaconOff, std::fabs(seen.norm() - way.norm()));
  const maths::SinCos turn =
      maths::sinCos(maths::atan2(way.y, way.x) - maths::atan2(seen.y, seen.x));
  const Vec g = shape.middle;
  const Point2<Field> camera{goal->position.x - (turn.cos * g.x - turn.sin * g.y),
                             goal->position.y - (turn.sin * g.x + turn.cos * g.y)};
  facts.outside = std::max(facts.outside, outsideOf(scene.field, camera));
}

}  // namespace

void addPlace(const Scene& scene, const GoalCandidate& c, const GoalShape& shape,
              const Landmarks& beacons, const GoalParams& p, GoalFacts& facts) {
  judgeEdges(scene, c, shape, p, facts);
  for (const LandmarkPercept& beacon : beacons)
    judgeBeacon(scene, goalKind(c.colour), shape, beacon, facts);
}

}  // namespace kelpie::vision
