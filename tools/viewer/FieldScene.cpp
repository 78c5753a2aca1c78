// SPDX-License-Identifier: Apache-2.0
#include "tools/viewer/FieldScene.h"

#include <array>
#include <cmath>
#include <vector>

#include "tools/viewer/Frames.h"
#include "tools/viewer/Points.h"
#include "tools/viewer/Shapes.h"

namespace kelpie::viewer {
namespace {

using foxglove::LinePrimitive;

constexpr double kCarpetThick = 1.0;  // cm, below the ground
constexpr double kPaint = 0.1;        // cm, height of the lines above it, so that they are seen
constexpr double kTurn = 2.0 * maths::kPi;
constexpr int kCircleCorners = 48;
constexpr double kPointEvery = 5.0;  // cm

foxglove::Color green() { return colour(0.13, 0.42, 0.16); }

std::vector<Point2<Field>> circleOf(const body::FieldDescription& field) {
  const double radius = 0.5 * (field.circleDiameter - field.lineWidth);
  std::vector<Point2<Field>> circle;
  for (int i = 0; i < kCircleCorners; ++i) {
    const double a = kTurn * i / kCircleCorners;
    circle.push_back(
        {0.5 * field.width + radius * std::cos(a), 0.5 * field.length + radius * std::sin(a)});
  }
  return circle;
}

foxglove::SceneEntity carpet(TimeUs time, const body::FieldDescription& field) {
  foxglove::SceneEntity result = entity(time, kMapFrame, "carpet");
  const body::Carpet green = body::carpetOf(field);
  const Point2<Field> middle = (green.low + green.high) * 0.5;
  foxglove::Vector3 size = inMap(green.high - green.low, kCarpetThick);
  addBox(result, poseAt(inMap(middle, -0.5 * kCarpetThick)), size, viewer::green());
  return result;
}

foxglove::SceneEntity lines(TimeUs time, const body::FieldDescription& field) {
  foxglove::SceneEntity result = entity(time, kMapFrame, "lines");
  const double width = metres(field.lineWidth);
  std::vector<foxglove::Vector3> ends;
  for (const body::FieldLine& line : field.lines)
    for (const Point2<Field>& p : {line.start, line.end}) ends.push_back(inMap(p, kPaint));
  addLines(result, LinePrimitive::LINE_LIST, width, ends, white());
  std::vector<foxglove::Vector3> corners;
  for (const Point2<Field>& p : circleOf(field)) corners.push_back(inMap(p, kPaint));
  addLines(result, LinePrimitive::LINE_LOOP, width, corners, white());
  std::vector<foxglove::Vector3> border;
  for (const body::BorderPiece& piece : body::borderOf(field)) {
    for (const Point2<Field>& p : {piece.foot.start, piece.foot.end}) border.push_back(inMap(p));
    for (const Point2<Field>& p : {piece.top.start, piece.top.end})
      border.push_back(inMap(p, field.borderWidth));
  }
  if (!border.empty()) addLines(result, LinePrimitive::LINE_LIST, width, border, white());
  return result;
}

// Back and sides of a goal; its mouth looks at the field.
foxglove::SceneEntity goal(TimeUs time, const body::FieldDescription& field,
                           const body::Landmark& mouth) {
  constexpr double kWall = 1.0;  // cm
  const bool far = mouth.position.y > 0.5 * field.length;
  foxglove::SceneEntity result = entity(time, kMapFrame, far ? "far goal" : "near goal");
  const double out = far ? field.goalDepth : -field.goalDepth;
  const foxglove::Color paint = colourOf(mouth.kind);
  const auto wall = [&](double x, double y, double wide, double deep) {
    const Point2<Field> middle = mouth.position + Point2<Field>{x, y};
    addBox(result, poseAt(inMap(middle, 0.5 * field.goalHeight)),
           inMap({wide, deep}, field.goalHeight), paint);
  };
  wall(0.0, out, field.goalWidth, kWall);
  for (const double side : {-0.5, 0.5})
    wall(side * field.goalWidth, 0.5 * out, kWall, field.goalDepth);
  return result;
}

struct Bands {
  foxglove::Color top;
  foxglove::Color below;
};

Bands bandsOf(LandmarkKind kind) {
  const foxglove::Color pink = colourOf(LandmarkKind::beaconBlueOnPink);
  const foxglove::Color blue = colourOf(LandmarkKind::goalBlue);
  const foxglove::Color yellow = colourOf(LandmarkKind::goalYellow);
  switch (kind) {
    case LandmarkKind::beaconBlueOnPink: return {blue, pink};
    case LandmarkKind::beaconPinkOnBlue: return {pink, blue};
    case LandmarkKind::beaconYellowOnPink: return {yellow, pink};
    default: return {pink, yellow};
  }
}

// From the ground up: two white bands, and the two that tell it from the others.
std::array<foxglove::Color, 4> bandColours(LandmarkKind kind) {
  const Bands bands = bandsOf(kind);
  return {white(), white(), bands.below, bands.top};
}

bool isGoal(LandmarkKind kind) {
  return kind == LandmarkKind::goalBlue || kind == LandmarkKind::goalYellow;
}

foxglove::SceneEntity beacons(TimeUs time, const body::FieldDescription& field) {
  foxglove::SceneEntity result = entity(time, kMapFrame, "beacons");
  const double band = 0.25 * field.beaconHeight;
  for (const body::Landmark& beacon : field.landmarks) {
    if (isGoal(beacon.kind)) continue;
    double z = 0.5 * band;
    for (const foxglove::Color& paint : bandColours(beacon.kind)) {
      addCylinder(result, inMap(beacon.position, z), metres(field.beaconRadius), metres(band),
                  paint);
      z += band;
    }
  }
  return result;
}

void addPointsOf(const body::FieldLine& line, Points& points) {
  const Point2<Field> way = line.end - line.start;
  const int steps = static_cast<int>(std::ceil(way.norm() / kPointEvery));
  for (int i = 0; i <= steps; ++i)
    points.add(inMap(line.start + way * (static_cast<double>(i) / steps)), white());
}

void addPost(const Point2<Field>& foot, double height, const foxglove::Color& paint,
             Points& points) {
  for (double z = 0.0; z <= height; z += kPointEvery) points.add(inMap(foot, z), paint);
}

void addBeacon(const body::FieldDescription& field, const body::Landmark& beacon, Points& points) {
  const auto bands = bandColours(beacon.kind);
  for (double z = 0.0; z < field.beaconHeight; z += kPointEvery) {
    const auto band = static_cast<std::size_t>(4.0 * z / field.beaconHeight);
    points.add(inMap(beacon.position, z), bands[band]);
  }
}

}  // namespace

foxglove::SceneUpdate fieldScene(TimeUs time, const body::FieldDescription& field) {
  foxglove::SceneUpdate scene;
  *scene.add_entities() = carpet(time, field);
  *scene.add_entities() = lines(time, field);
  *scene.add_entities() = beacons(time, field);
  for (const body::Landmark& landmark : field.landmarks)
    if (isGoal(landmark.kind)) *scene.add_entities() = goal(time, field, landmark);
  return scene;
}

foxglove::PointCloud fieldPoints(TimeUs time, const body::FieldDescription& field) {
  Points points(time, kMapFrame);
  for (const body::FieldLine& line : field.lines) addPointsOf(line, points);
  for (const Point2<Field>& p : circleOf(field)) points.add(inMap(p), white());
  for (const body::Landmark& landmark : field.landmarks) {
    if (!isGoal(landmark.kind)) {
      addBeacon(field, landmark, points);
      continue;
    }
    for (const double side : {-0.5, 0.5})
      addPost(landmark.position + Point2<Field>{side * field.goalWidth, 0.0}, field.goalHeight,
              colourOf(landmark.kind), points);
  }
  return points.cloud();
}

}  // namespace kelpie::viewer
