// SPDX-License-Identifier: Apache-2.0
#include "robot/body/FieldDescription.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace kelpie::body {
namespace {

void addGoalBox(FieldDescription& f, double goalLine, double boxLine) {
  const double half = f.lineWidth / 2;
  const double left = (f.width - f.boxWidth) / 2 + half;
  const double right = (f.width + f.boxWidth) / 2 - half;
  f.lines.push_back({{left, goalLine}, {left, boxLine}});
  f.lines.push_back({{left, boxLine}, {right, boxLine}});
  f.lines.push_back({{right, boxLine}, {right, goalLine}});
}

// A border takes the place of the side lines, and of the goal lines outside the mouth.
void addEdges(FieldDescription& f, double left, double bottom) {
  const double right = f.width - left;
  const double top = f.length - bottom;
  const bool border = f.borderWidth > 0.0;
  const double from = border ? (f.width - f.goalWidth) / 2 : left;
  const double to = border ? (f.width + f.goalWidth) / 2 : right;
  f.lines.push_back({{from, bottom}, {to, bottom}});
  f.lines.push_back({{to, top}, {from, top}});
  if (border) return;
  f.lines.push_back({{right, bottom}, {right, top}});
  f.lines.push_back({{left, top}, {left, bottom}});
}

// Sizes are between outer edges, so the middle of a line is half a line width inside. The border
// stands inside width and length, its foot on the outer edge of the goal lines.
void addLines(FieldDescription& f) {
  const double half = f.lineWidth / 2;
  const double bottom = f.borderWidth + half;
  addEdges(f, half, bottom);
  const double side = f.borderWidth > 0.0 ? f.borderWidth : half;
  f.lines.push_back({{side, f.length / 2}, {f.width - side, f.length / 2}});
  const double box = f.borderWidth + f.boxDepth - half;
  addGoalBox(f, bottom, box);
  addGoalBox(f, f.length - bottom, f.length - box);
}

// The corner of the own left; `corner` is where its triangle ends along foot and upper edge.
struct BorderEnds {
  double foot;
  double top;
};

BorderEnds borderEnds(const FieldDescription& f) {
  const double b = f.borderWidth;
  if (f.borderCorner <= 0.0) return {b, 0.0};
  // The triangle's upper edge is parallel to its foot, borderWidth farther out.
  return {b + f.borderCorner, 2.0 * b + f.borderCorner - std::sqrt(2.0) * b};
}

// The same piece in all four quarters of the field, twice where it is its own mirror image.
void addBorderPiece(const FieldDescription& f, const BorderPiece& piece, bool alongX, bool alongY,
                    Border& border) {
  const auto mirrored = [&f](Point2<Field> p, bool x, bool y) {
    return Point2<Field>{x ? f.width - p.x : p.x, y ? f.length - p.y : p.y};
  };
  for (const bool x : {false, true})
    for (const bool y : {false, true}) {
      if ((x && !alongX) || (y && !alongY)) continue;
      const auto turned = [&](const FieldLine& line) {
        return FieldLine{mirrored(line.start, x, y), mirrored(line.end, x, y)};
      };
      border.push_back({turned(piece.foot), turned(piece.top)});
    }
}

// The red team's view (facts-2005 section 1): its own goal is yellow; "X on Y" = X above Y.
void addLandmarks(FieldDescription& f, double beaconX, double beaconY) {
  const double middle = f.width / 2;
  f.landmarks.push_back({LandmarkKind::goalBlue, {middle, f.length}});
  f.landmarks.push_back({LandmarkKind::goalYellow, {middle, 0.0}});
  f.landmarks.push_back({LandmarkKind::beaconBlueOnPink, {-beaconX, f.length - beaconY}});
  f.landmarks.push_back({LandmarkKind::beaconPinkOnBlue, {f.width + beaconX, f.length - beaconY}});
  f.landmarks.push_back({LandmarkKind::beaconYellowOnPink, {-beaconX, beaconY}});
  f.landmarks.push_back({LandmarkKind::beaconPinkOnYellow, {f.width + beaconX, beaconY}});
}

FieldDescription field2006() {
  FieldDescription f;
  addLines(f);
  addLandmarks(f, 15.0, 135.0);
  return f;
}

// Measured at the venue: data/field/field_2005.csv.
FieldDescription fieldOsaka2005() {
  FieldDescription f;
  f.width = 363.0;
  f.length = 542.0;
  f.boxWidth = 128.0;
  f.lineWidth = 2.4;
  f.sideFringe = 19.0;
  f.endFringe = 29.0;
  addLines(f);
  addLandmarks(f, 13.0, 136.0);
  return f;
}

// The smaller field before 2005: 45 degree border, beacons at the corners.
FieldDescription field2004() {
  FieldDescription f;
  f.width = 290.0;
  f.length = 440.0;
  f.goalWidth = 60.0;
  f.boxWidth = 100.0;
  f.boxDepth = 50.0;
  f.circleDiameter = 30.0;
  f.lineWidth = 2.4;
  f.sideFringe = 0.0;
  f.endFringe = 0.0;
  f.borderWidth = 10.0;
  f.borderCorner = 50.0;
  addLines(f);
  addLandmarks(f, 5.0, -5.0);
  return f;
}

}  // namespace

Expected<FieldDescription> fieldDescription(std::string_view name) {
  if (name == "2006") return field2006();
  if (name == "osaka2005") return fieldOsaka2005();
  if (name == "2004") return field2004();
  return Error{"no field '" + std::string(name) + "'; there are 2006, osaka2005 and 2004"};
}

Point2<Field> throwInPlace(const FieldDescription& field, Point2<Field> ball) {
  const Rules& rules = field.rules;
  const bool left = ball.x < 0.5 * field.width;
  return {left ? rules.throwInFromSide : field.width - rules.throwInFromSide,
          maths::clamp(ball.y, rules.throwInFromEnd, field.length - rules.throwInFromEnd)};
}

Carpet carpetOf(const FieldDescription& field) {
  return {{-field.sideFringe, -field.endFringe},
          {field.width + field.sideFringe, field.length + field.endFringe}};
}

double carpetDistance(const FieldDescription& field, Point2<Field> p) {
  return distance(p, carpetOf(field).nearest(p));
}

std::array<double, 8> wallAround(const FieldDescription& field, double beyond) {
  const Carpet carpet = carpetOf(field);
  const Point2<Field> low = carpet.low - Point2<Field>{beyond, beyond};
  const Point2<Field> high = carpet.high + Point2<Field>{beyond, beyond};
  return {low.x, low.y, high.x, low.y, high.x, high.y, low.x, high.y};
}

Border borderOf(const FieldDescription& f) {
  Border border;
  const double b = f.borderWidth;
  if (b <= 0.0) return border;
  const BorderEnds ends = borderEnds(f);
  const double post = (f.width - f.goalWidth) / 2;
  const FieldLine side{{b, ends.foot}, {b, f.length - ends.foot}};
  const FieldLine sideTop{{0.0, ends.top}, {0.0, f.length - ends.top}};
  addBorderPiece(f, {side, sideTop}, true, false, border);
  const FieldLine end{{ends.foot, b}, {post, b}};
  addBorderPiece(f, {end, {{ends.top, 0.0}, {post, 0.0}}}, true, true, border);
  if (f.borderCorner > 0.0) {
    const FieldLine corner{{b, ends.foot}, {ends.foot, b}};
    addBorderPiece(f, {corner, {{0.0, ends.top}, {ends.top, 0.0}}}, true, true, border);
  }
  return border;
}

const Landmark* findLandmark(const LandmarkMap& map, LandmarkKind kind) {
  const auto it =
      std::find_if(map.begin(), map.end(), [kind](const Landmark& l) { return l.kind == kind; });
  return it == map.end() ? nullptr : it;
}

LandmarkMap landmarksFor(const FieldDescription& field, TeamColour team) {
  auto landmarks = field.landmarks;
  if (team == TeamColour::red) return landmarks;
  for (auto& landmark : landmarks)
    landmark.position = {field.width - landmark.position.x, field.length - landmark.position.y};
  return landmarks;
}

}  // namespace kelpie::body
