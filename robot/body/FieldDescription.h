// SPDX-License-Identifier: Apache-2.0
// The playing field as data: sizes, lines, landmarks. Three are shipped: "2006", "osaka2005" and
// "2004" (checklist K01..K04 and K08; numbers of osaka2005 measured, facts-2005 section 1).
#pragma once

#include <array>
#include <string_view>

#include "robot/body/Rules.h"
#include "robot/core/Expected.h"
#include "robot/core/FixedVector.h"
#include "robot/core/Maths.h"
#include "robot/core/types/FrameInput.h"
#include "robot/core/types/Geometry.h"
#include "robot/core/types/Percepts.h"

namespace kelpie::body {

constexpr double kBallRadius = 4.2;

struct FieldLine {
  Point2<Field> start;
  Point2<Field> end;

  template <int = 0>
  static constexpr auto fields() {
    return fieldList(field("start", &FieldLine::start), field("end", &FieldLine::end));
  }
};

// A beacon or the middle of a goal mouth.
struct Landmark {
  LandmarkKind kind = LandmarkKind::goalBlue;
  Point2<Field> position;

  template <int = 0>
  static constexpr auto fields() {
    return fieldList(field("kind", &Landmark::kind, "", 0, 5),
                     field("position", &Landmark::position));
  }
};

struct FieldDescription {
  double width = 360.0;   // between the outer edges of the side lines
  double length = 540.0;  // between the outer edges of the goal lines
  double goalWidth = 80.0;
  double goalDepth = 30.0;
  double goalHeight = 30.0;
  double boxWidth = 130.0;
  double boxDepth = 65.0;
  double circleDiameter = 36.0;
  double lineWidth = 2.5;
  double sideFringe = 20.0;   // green carpet beyond the side lines
  double endFringe = 30.0;    // green carpet beyond the goal lines
  double borderWidth = 0.0;   // 45 degree white border inside width and length, 0 = none
  double borderCorner = 0.0;  // legs of the border's corner triangles
  double beaconRadius = 5.0;
  double beaconHeight = 40.0;  // four equal bands, the upper two coloured, the lower two white
  Rules rules;
  FixedVector<FieldLine, 24> lines;  // centre lines of the painted lines, without the circle
  FixedVector<Landmark, kLandmarkKindCount> landmarks;  // as the red team sees them

  template <int = 0>
  static constexpr auto fields() {
    return fieldList(field("width", &FieldDescription::width, "cm", 100, 1000),
                     field("length", &FieldDescription::length, "cm", 100, 1500),
                     field("goalWidth", &FieldDescription::goalWidth, "cm", 10, 200),
                     field("goalDepth", &FieldDescription::goalDepth, "cm", 0, 100),
                     field("goalHeight", &FieldDescription::goalHeight, "cm", 0, 100),
                     field("boxWidth", &FieldDescription::boxWidth, "cm", 10, 500),
                     field("boxDepth", &FieldDescription::boxDepth, "cm", 10, 300),
                     field("circleDiameter", &FieldDescription::circleDiameter, "cm", 0, 300),
                     field("lineWidth", &FieldDescription::lineWidth, "cm", 0, 10),
                     field("sideFringe", &FieldDescription::sideFringe, "cm", 0, 200),
                     field("endFringe", &FieldDescription::endFringe, "cm", 0, 200),
                     field("borderWidth", &FieldDescription::borderWidth, "cm", 0, 50),
                     field("borderCorner", &FieldDescription::borderCorner, "cm", 0, 200),
                     field("beaconRadius", &FieldDescription::beaconRadius, "cm", 1, 30),
                     field("beaconHeight", &FieldDescription::beaconHeight, "cm", 10, 100),
                     field("rules", &FieldDescription::rules),
                     field("lines", &FieldDescription::lines),
                     field("landmarks", &FieldDescription::landmarks));
  }
};

// "2006", "osaka2005" or "2004"; an error names the three for anything else.
Expected<FieldDescription> fieldDescription(std::string_view name);

// Where a ball that left the field at that place is put back by the rules.
Point2<Field> throwInPlace(const FieldDescription& field, Point2<Field> ball);

// The green: the field and its fringes.
struct Carpet {
  Point2<Field> low;
  Point2<Field> high;

  Point2<Field> nearest(Point2<Field> p) const {
    return {maths::clamp(p.x, low.x, high.x), maths::clamp(p.y, low.y, high.y)};
  }
};
Carpet carpetOf(const FieldDescription& field);

// From a point to the carpet, in cm: 0 on it.
double carpetDistance(const FieldDescription& field, Point2<Field> p);

// x, y of the corners of a wall that stands so far beyond the carpet, going round.
std::array<double, 8> wallAround(const FieldDescription& field, double beyond);

// A straight piece of the white border: its foot on the carpet and its upper edge, which is as much
// farther out as it is higher, borderWidth.
struct BorderPiece {
  FieldLine foot;
  FieldLine top;
};
using Border = FixedVector<BorderPiece, 10>;

// Sides, corner triangles, and ends that are open at the goals; nothing on a field without a
// border.
Border borderOf(const FieldDescription& field);

using LandmarkMap = FixedVector<Landmark, kLandmarkKindCount>;

// Nothing when the map has none of the kind.
const Landmark* findLandmark(const LandmarkMap& map, LandmarkKind kind);

// The landmarks with coordinates for the given team: the blue team's field is turned by 180 deg.
LandmarkMap landmarksFor(const FieldDescription& field, TeamColour team);

}  // namespace kelpie::body
