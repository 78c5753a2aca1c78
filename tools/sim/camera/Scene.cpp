// SPDX-License-Identifier: Apache-2.0
#include "tools/sim/camera/Scene.h"

#include <algorithm>
#include <cmath>

namespace kelpie::sim {
namespace {

void addGoal(Scene& scene, const body::FieldDescription& field, const body::Landmark& goal) {
  const Colour colour = goal.kind == LandmarkKind::goalBlue ? colours::kBlue : colours::kYellow;
  const double half = field.goalWidth / 2.0;
  const double y = goal.position.y;
  const double back = y < field.length / 2.0 ? y - field.goalDepth : y + field.goalDepth;
  const Point2<Field> left{goal.position.x - half, y};
  const Point2<Field> right{goal.position.x + half, y};
  const std::array<double, 2> walls{0.0, field.goalHeight};
  Solid solid;
  solid.quads.push_back(uprightQuad({left.x, back}, {right.x, back}, walls, colour));
  solid.quads.push_back(uprightQuad(left, {left.x, back}, walls, brighter(colour, 0.92)));
  solid.quads.push_back(uprightQuad(right, {right.x, back}, walls, brighter(colour, 1.06)));
  for (Quad& quad : solid.quads) quad.slope = 0.12;
  enclose(solid);
  scene.fixtures.push_back(solid);
}

Colour upperColour(LandmarkKind kind) {
  switch (kind) {
    case LandmarkKind::beaconBlueOnPink: return colours::kBlue;
    case LandmarkKind::beaconYellowOnPink: return colours::kYellow;
    default: return colours::kPink;
  }
}

Colour lowerColour(LandmarkKind kind) {
  switch (kind) {
    case LandmarkKind::beaconPinkOnBlue: return colours::kBlue;
    case LandmarkKind::beaconPinkOnYellow: return colours::kYellow;
    default: return colours::kPink;
  }
}

void addBeacon(Scene& scene, const body::FieldDescription& field, const body::Landmark& mark) {
  Cylinder cylinder;
  cylinder.centre = mark.position;
  cylinder.radius = field.beaconRadius;
  for (std::size_t i = 0; i < cylinder.height.size(); ++i) {
    cylinder.height[i] = field.beaconHeight * static_cast<double>(i) / 4.0;
  }
  cylinder.band = {colours::kWhite, colours::kWhite, lowerColour(mark.kind),
                   upperColour(mark.kind)};
  scene.beacons.push_back(cylinder);
}

// A painted line as a strip of the line's width around its centre line.
Quad strip(const body::FieldLine& line, double width) {
  const Point2<Field> along = line.end - line.start;
  const double length = along.norm() > 0.0 ? along.norm() : 1.0;
  const Point2<Field> unit = along * (1.0 / length);
  const Point2<Field> side{-unit.y * width / 2.0, unit.x * width / 2.0};
  const Point2<Field> from = line.start - unit * (width / 2.0);
  const Point2<Field> to = line.end + unit * (width / 2.0);
  Quad quad;
  quad.colour = colours::kWhite;
  quad.corner = {FieldPoint3{from.x + side.x, from.y + side.y, 0.0},
                 FieldPoint3{to.x + side.x, to.y + side.y, 0.0},
                 FieldPoint3{to.x - side.x, to.y - side.y, 0.0},
                 FieldPoint3{from.x - side.x, from.y - side.y, 0.0}};
  return quad;
}

void addLines(Scene& scene, const body::FieldDescription& field) {
  const Point2<Field> centre{field.width / 2.0, field.length / 2.0};
  const double radius = field.circleDiameter / 2.0;
  if (radius > 0.0) {
    scene.circle.push_back({centre, radius, colours::kWhite, 0.0});
    scene.circle.push_back({centre, radius - field.lineWidth, scene.green, 0.0});
  }
  for (const body::FieldLine& line : field.lines) {
    scene.lines.push_back(strip(line, field.lineWidth));
  }
}

// The white border of the 2004 field.
void addBorder(Scene& scene, const body::FieldDescription& field) {
  const double height = field.borderWidth;
  for (const body::BorderPiece& piece : body::borderOf(field)) {
    Quad quad;
    quad.colour = colours::kWhite;
    quad.corner = {FieldPoint3{piece.foot.start.x, piece.foot.start.y, 0.0},
                   FieldPoint3{piece.foot.end.x, piece.foot.end.y, 0.0},
                   FieldPoint3{piece.top.end.x, piece.top.end.y, height},
                   FieldPoint3{piece.top.start.x, piece.top.start.y, height}};
    Solid solid;
    solid.quads.push_back(quad);
    enclose(solid);
    scene.fixtures.push_back(solid);
  }
}

// Where the tape's middle is stays.
body::FieldDescription taped(body::FieldDescription field, double width) {
  if (width <= 0.0) return field;
  if (field.circleDiameter > 0.0) field.circleDiameter += width - field.lineWidth;
  field.lineWidth = width;
  return field;
}

}  // namespace

Quad uprightQuad(Point2<Field> a, Point2<Field> b, std::array<double, 2> lowHigh, Colour colour) {
  Quad quad;
  quad.corner = {FieldPoint3{a.x, a.y, lowHigh[0]}, FieldPoint3{b.x, b.y, lowHigh[0]},
                 FieldPoint3{b.x, b.y, lowHigh[1]}, FieldPoint3{a.x, a.y, lowHigh[1]}};
  quad.colour = colour;
  return quad;
}

Quad groundQuad(Point2<Field> low, Point2<Field> high, Colour colour) {
  Quad quad;
  quad.corner = {FieldPoint3{low.x, low.y, 0.0}, FieldPoint3{high.x, low.y, 0.0},
                 FieldPoint3{high.x, high.y, 0.0}, FieldPoint3{low.x, high.y, 0.0}};
  quad.colour = colour;
  return quad;
}

void enclose(Solid& solid) {
  FieldPoint3 sum;
  double count = 0.0;
  for (const Quad& quad : solid.quads) {
    for (const FieldPoint3& corner : quad.corner) {
      sum = sum + corner;
      count += 1.0;
    }
  }
  if (count > 0.0) solid.centre = {sum.x / count, sum.y / count, sum.z / count};
  solid.radius = 0.0;
  for (const Quad& quad : solid.quads) {
    for (const FieldPoint3& corner : quad.corner) {
      const FieldPoint3 d = corner - solid.centre;
      solid.radius = std::max(solid.radius, std::sqrt(d.x * d.x + d.y * d.y + d.z * d.z));
    }
  }
}

double lightAt(const Scene& scene, Point2<Field> place) {
  const Point2<Field> middle = (scene.carpet[0] + scene.carpet[1]) * 0.5;
  const Point2<Field> way = place - middle;
  const double half = 0.5 * (scene.carpet[1].y - scene.carpet[0].y);
  const double along = way.x * scene.towardsLight.x + way.y * scene.towardsLight.y;
  return maths::clamp(along / half, -1.0, 1.0);
}

Scene fieldScene(const body::FieldDescription& nominal, std::uint64_t crowdSeed,
                 const Venue& venue) {
  const body::FieldDescription field = taped(nominal, venue.tapeWidth);
  Scene scene;
  scene.green = brighter(scene.green, venue.carpet);
  scene.stripes = venue.stripes;
  scene.light = venue.light;
  scene.towardsLight = {venue.light.side.cos(), venue.light.side.sin()};
  const body::Carpet carpet = body::carpetOf(field);
  scene.carpet = {carpet.low, carpet.high};
  addLines(scene, field);
  for (const body::Landmark& mark : field.landmarks) {
    if (mark.kind == LandmarkKind::goalBlue || mark.kind == LandmarkKind::goalYellow) {
      addGoal(scene, field, mark);
      ++scene.goals;
    } else {
      addBeacon(scene, field, mark);
    }
  }
  addBorder(scene, field);
  addSurroundings(scene, field, venue.room);
  if (crowdSeed != 0) addCrowd(scene, crowdSeed);
  return scene;
}

void setBall(Scene& scene, Point2<Field> position) {
  scene.balls.clear();
  scene.balls.push_back(
      {{position.x, position.y, body::kBallRadius}, body::kBallRadius, colours::kOrange});
}

}  // namespace kelpie::sim
