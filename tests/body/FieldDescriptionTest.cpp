// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <limits>
#include <map>
#include <sstream>
#include <string>

#include "robot/body/FieldDescription.h"

namespace kelpie::body {
namespace {

Point2<Field> landmarkAt(const FieldDescription& field, LandmarkKind kind,
                         TeamColour team = TeamColour::red) {
  for (const Landmark& landmark : landmarksFor(field, team))
    if (landmark.kind == kind) return landmark.position;
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  return {kNaN, kNaN};
}

bool hasLine(const FieldDescription& field, Point2<Field> a, Point2<Field> b) {
  for (const FieldLine& line : field.lines) {
    if (distance(line.start, a) + distance(line.end, b) < 1e-9) return true;
    if (distance(line.start, b) + distance(line.end, a) < 1e-9) return true;
  }
  return false;
}

TEST(FieldDescription, BeaconsOf2006StandOnTheSidesAQuarterFromTheEnds) {
  const auto field = *fieldDescription("2006");
  const auto check = [&](LandmarkKind kind, double x, double y) {
    EXPECT_EQ(landmarkAt(field, kind).x, x);
    EXPECT_EQ(landmarkAt(field, kind).y, y);
  };
  check(LandmarkKind::beaconYellowOnPink, -15, 135);
  check(LandmarkKind::beaconPinkOnYellow, 375, 135);
  check(LandmarkKind::beaconBlueOnPink, -15, 405);
  check(LandmarkKind::beaconPinkOnBlue, 375, 405);
  check(LandmarkKind::goalBlue, 180, 540);
  check(LandmarkKind::goalYellow, 180, 0);
}

// Outer edges are what is measured, so a line's middle lies half its width further in.
TEST(FieldDescription, LineMiddlesLieHalfALineInsideTheOuterEdges) {
  const auto field = *fieldDescription("2006");
  EXPECT_TRUE(hasLine(field, {1.25, 1.25}, {1.25, 538.75}));
  EXPECT_TRUE(hasLine(field, {1.25, 1.25}, {358.75, 1.25}));
  EXPECT_TRUE(hasLine(field, {1.25, 270}, {358.75, 270}));
  EXPECT_TRUE(hasLine(field, {116.25, 63.75}, {243.75, 63.75}));
  EXPECT_TRUE(hasLine(field, {116.25, 1.25}, {116.25, 63.75}));
}

TEST(FieldDescription, BlueTeamSeesTheFieldTurnedByHalfATurn) {
  for (const char* name : {"2006", "osaka2005", "2004"}) {
    const auto field = *fieldDescription(name);
    for (const Landmark& landmark : field.landmarks) {
      const auto blue = landmarkAt(field, landmark.kind, TeamColour::blue);
      EXPECT_EQ(blue.x + landmark.position.x, field.width);
      EXPECT_EQ(blue.y + landmark.position.y, field.length);
    }
    EXPECT_EQ(landmarkAt(field, LandmarkKind::goalBlue, TeamColour::blue).y, 0.0);
  }
}

TEST(FieldDescription, LinesAreTheirOwnMirrorImages) {
  for (const char* name : {"2006", "osaka2005", "2004"}) {
    const auto field = *fieldDescription(name);
    EXPECT_GE(field.lines.size(), 7u);
    for (const FieldLine& line : field.lines) {
      const auto across = [&](Point2<Field> p) { return Point2<Field>{field.width - p.x, p.y}; };
      const auto along = [&](Point2<Field> p) { return Point2<Field>{p.x, field.length - p.y}; };
      EXPECT_TRUE(hasLine(field, across(line.start), across(line.end))) << name;
      EXPECT_TRUE(hasLine(field, along(line.start), along(line.end))) << name;
    }
  }
}

TEST(FieldDescription, OnlyTheOldFieldHasABorder) {
  EXPECT_EQ(fieldDescription("2006")->borderWidth, 0.0);
  EXPECT_EQ(fieldDescription("osaka2005")->borderWidth, 0.0);
  EXPECT_GT(fieldDescription("2004")->borderWidth, 0.0);
  EXPECT_GT(fieldDescription("2004")->borderCorner, 0.0);
}

// 270 x 420 of green, 10 cm of border around it (rule book of 2004: 2.7 m x 4.2 m).
TEST(FieldDescription, OldFieldHasNoSideLinesAndGoalLinesOnlyInTheMouth) {
  const auto field = *fieldDescription("2004");
  EXPECT_EQ(field.lines.size(), 9u);
  EXPECT_TRUE(hasLine(field, {115, 11.2}, {175, 11.2}));
  EXPECT_TRUE(hasLine(field, {10, 220}, {280, 220}));
  EXPECT_TRUE(hasLine(field, {96.2, 58.8}, {193.8, 58.8}));
}

TEST(FieldDescription, TheFootOfTheBorderIsClosedButForTheGoals) {
  const auto field = *fieldDescription("2004");
  const Border border = borderOf(field);
  EXPECT_EQ(border.size(), 10u);
  int loose = 0;
  for (const BorderPiece& piece : border)
    for (const Point2<Field>& end : {piece.foot.start, piece.foot.end}) {
      int here = 0;
      for (const BorderPiece& other : border)
        here += (distance(other.foot.start, end) < 1e-9) + (distance(other.foot.end, end) < 1e-9);
      if (here == 2) continue;
      ++loose;
      EXPECT_NEAR(std::fabs(end.x - field.width / 2), field.goalWidth / 2, 1e-9);
    }
  EXPECT_EQ(loose, 4);
  EXPECT_TRUE(borderOf(*fieldDescription("2006")).empty());
}

TEST(FieldDescription, TheBordersUpperEdgeIsAsMuchFartherOutAsHigher) {
  const auto field = *fieldDescription("2004");
  for (const BorderPiece& piece : borderOf(field)) {
    const Point2<Field> way = piece.foot.end - piece.foot.start;
    const Point2<Field> up = piece.top.start - piece.foot.start;
    const double away = std::fabs(way.x * up.y - way.y * up.x) / way.norm();
    EXPECT_NEAR(away, field.borderWidth, 1e-9);
  }
}

TEST(FieldDescription, UnknownNameIsRefusedWithTheNamesThatExist) {
  const auto none = fieldDescription("2007");
  ASSERT_FALSE(none.ok());
  for (const char* part : {"2007", "2006", "osaka2005", "2004"})
    EXPECT_NE(none.error().find(part), std::string::npos);
}

// Column of the shared table of field sizes; empty where the table is absent.
std::map<std::string, double> sharedColumn(int column) {
  std::ifstream file(KELPIE_SOURCE_DIR "/../shared/data/field/field_2005.csv");
  std::map<std::string, double> values;
  std::string line;
  while (std::getline(file, line)) {
    std::istringstream cells(line);
    std::string name;
    std::getline(cells, name, ',');
    std::string cell;
    for (int i = 0; i < column; ++i) std::getline(cells, cell, ',');
    if (!cell.empty() && std::isdigit(static_cast<unsigned char>(cell[0])))
      values[name] = std::stod(cell);
  }
  return values;
}

void expectSizes(const FieldDescription& f, std::map<std::string, double> table) {
  EXPECT_EQ(f.width, table["field_width"]);
  EXPECT_EQ(f.length, table["field_length"]);
  EXPECT_EQ(f.goalWidth, table["goal_width"]);
  EXPECT_EQ(f.boxWidth, table["goalbox_width"]);
  EXPECT_EQ(f.boxDepth, table["goalbox_depth"]);
  EXPECT_EQ(f.circleDiameter, table["circle_diameter"]);
  EXPECT_EQ(f.lineWidth, table["line_width"]);
}

TEST(FieldDescription, SizesAreThoseOfTheSharedTable) {
  const auto rule = sharedColumn(1);
  if (rule.empty()) GTEST_SKIP() << "no ../shared/data/field/field_2005.csv";
  expectSizes(*fieldDescription("2006"), rule);
  expectSizes(*fieldDescription("osaka2005"), sharedColumn(2));
  expectSizes(*fieldDescription("2004"), sharedColumn(3));
}

TEST(FieldDescription, TheDistanceToTheCarpetIsToItsNearestPoint) {
  const FieldDescription field = *fieldDescription("2006");  // fringes of 20 and 30 cm
  EXPECT_EQ(carpetDistance(field, {180.0, 270.0}), 0.0);
  EXPECT_EQ(carpetDistance(field, {-20.0, 570.0}), 0.0);
  EXPECT_EQ(carpetDistance(field, {-24.0, 100.0}), 4.0);
  EXPECT_EQ(carpetDistance(field, {100.0, 577.0}), 7.0);
  EXPECT_NEAR(carpetDistance(field, {383.0, -34.0}), 5.0, 1e-12);  // past a corner
  EXPECT_EQ(carpetOf(field).nearest({383.0, -34.0}).x, 380.0);
}

}  // namespace
}  // namespace kelpie::body
