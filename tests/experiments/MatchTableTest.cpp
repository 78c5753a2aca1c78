// SPDX-License-Identifier: Apache-2.0
// The thesis' own way to the lines: the table of match values and the ascent on it.
#include <gtest/gtest.h>

#include "tests/gps/Field2004.h"
#include "tests/gps/Field2006.h"
#include "tools/experiments/baselines/MatchTable.h"

namespace kelpie::gps {
namespace {

double valueOf(const MatchTable& table, double x, double y) {
  return table.at({x, y}, Interpolation::thesis).value;
}

// 470 x 380 cells of 2 cm are the field of 540 x 360 and 200 cm on each side, of 4 B each.
TEST(MatchTable, OfTheFieldOf2006HasTheThesisSize) {
  const MatchTables tables(field2006(), features(), {});
  for (const MatchTable* table : {&tables.lines, &tables.border, &tables.carpet})
    EXPECT_EQ(table->bytes(), 714400U);
  EXPECT_EQ(MatchTables(field2004(), features2004(), {}).lines.bytes(), 420U * 345U * 4U);
}

// In front of the line through the middle, at x = 90, nothing else is as near: the side line is 89
// cm away and the circle 72.
TEST(MatchTable, FallsWithTheDistanceFromALineAsEquation3_2) {
  const MatchTables tables(field2006(), features(), {});
  EXPECT_NEAR(valueOf(tables.lines, 90.0, 270.0), 1.0, 1e-6);
  EXPECT_NEAR(valueOf(tables.lines, 90.0, 280.0), 0.714, 0.0005);
  EXPECT_NEAR(valueOf(tables.lines, 90.0, 270.0 + 15.81), 0.5, 0.001);
  EXPECT_NEAR(valueOf(tables.lines, 90.0, 290.0), 0.385, 0.0005);
  EXPECT_NEAR(valueOf(tables.lines, 90.0, 320.0), 0.091, 0.0005);
  EXPECT_NEAR(valueOf(tables.carpet, 90.0, 320.0), 1.0, 1e-6);
  EXPECT_NEAR(valueOf(tables.carpet, -70.0, 320.0), 0.091, 0.0005) << "50 cm from its fringe";
  EXPECT_NEAR(valueOf(tables.border, 90.0, 320.0), 0.0, 1e-6) << "there is none";
}

TEST(MatchTable, FallsAsABellByEquation3_3) {
  const MatchTables tables(field2006(), features(), {MatchDecay::bell, kBellSharpness});
  EXPECT_NEAR(valueOf(tables.lines, 90.0, 270.0), 1.0, 1e-6);
  EXPECT_NEAR(valueOf(tables.lines, 90.0, 280.0), 0.905, 0.0005);
  EXPECT_NEAR(valueOf(tables.lines, 90.0, 270.0 + 26.33), 0.5, 0.001);
  EXPECT_NEAR(valueOf(tables.lines, 90.0, 320.0), 0.082, 0.0005);
  EXPECT_NEAR(matchAt(5.0, {MatchDecay::bell, kBellSharpness}), 0.975, 0.0005);
  EXPECT_NEAR(matchAt(100.0, {MatchDecay::bell, kBellSharpness}), 0.00005, 5e-6);
}

TEST(MatchTable, IsReadBetweenItsCellsInTwoWays) {
  const MatchTables tables(field2006(), features(), {});
  EXPECT_NEAR(tables.lines.at({60.0, 280.0}, Interpolation::bilinear).value, 0.714, 0.0005);
  EXPECT_NEAR(tables.lines.at({61.3, 283.1}, Interpolation::thesis).value,
              tables.lines.at({61.3, 283.1}, Interpolation::bilinear).value, 0.01);
}

// The border's foot stands 10 cm inside the field of 290 x 440, its upper edge at x = 0.
TEST(MatchTable, AtHomeTheGreenEndsAtTheBordersFoot) {
  const MatchTables home(field2004(), features2004(), {});
  EXPECT_NEAR(valueOf(home.border, 10.0, 220.0), 1.0, 1e-6);
  EXPECT_NEAR(valueOf(home.border, 60.0, 220.0), 0.091, 0.0005);
  EXPECT_NEAR(valueOf(home.border, -40.0, 220.0), 0.091, 0.0005);
  EXPECT_NEAR(valueOf(home.carpet, 12.0, 220.0), 1.0, 1e-6);
  EXPECT_NEAR(valueOf(home.carpet, 0.0, 220.0), 0.714, 0.0005);
  EXPECT_NEAR(valueOf(home.carpet, -40.0, 220.0), 0.091, 0.0005);
  // 20 sqrt(2) cm outside the triangle from (10, 60) to (60, 10): 1 / (1 + 0.004 * 800).
  EXPECT_NEAR(valueOf(home.carpet, 14.0, 16.0), 1.0 / 4.2, 1e-6);
  EXPECT_NEAR(valueOf(home.carpet, 34.0, 36.0), 1.0, 1e-6);
}

// An outer wall 88 cm away: its foot is a border too, and all in between is green.
TEST(MatchTable, InLisbonASecondBorderAndGreenLieBeyondTheFirst) {
  const MatchOptions lisbon{MatchDecay::reciprocal, 0.004, kSeenInLisbon};
  const MatchTables tables(field2004(), features2004(), lisbon);
  for (const double y : {-88.0, 528.0}) EXPECT_NEAR(valueOf(tables.border, 144.0, y), 1.0, 1e-6);
  for (const double x : {-88.0, 10.0, 280.0, 378.0})
    EXPECT_NEAR(valueOf(tables.border, x, 220.0), 1.0, 1e-6);
  EXPECT_NEAR(valueOf(tables.border, -38.0, 220.0), 1.0 / (1.0 + 0.004 * 48.0 * 48.0), 1e-6);
  EXPECT_NEAR(valueOf(tables.border, -138.0, 220.0), 0.091, 0.0005);
  for (const double x : {-88.0, -40.0, 0.0, 10.0, 144.0, 290.0, 378.0})
    EXPECT_NEAR(valueOf(tables.carpet, x, 220.0), 1.0, 1e-6) << x;
  EXPECT_NEAR(valueOf(tables.carpet, 4.0, 220.0), 1.0 / (1.0 + 0.004 * 16.0), 1e-6) << "slope";
  EXPECT_NEAR(valueOf(tables.carpet, -138.0, 220.0), 0.091, 0.0005);
  EXPECT_NEAR(valueOf(tables.carpet, 10.0, 10.0), 1.0, 1e-6) << "behind a corner's triangle";
  const MatchTables home(field2004(), features2004(), {});
  EXPECT_EQ(valueOf(tables.lines, 90.0, 320.0), valueOf(home.lines, 90.0, 320.0));
}

// Seen from (60, 220) to the left: the border's foot 50 cm ahead and the wall's foot, as many
// points of each, and green beyond the border. At home the wall's points are 98 cm from the border
// and the green ones 50.
TEST(MatchTable, APoseByTheBorderInLisbonMatchesOnlyItsOwnTables) {
  const Pose2 pose{{60.0, 220.0}, Angle::deg(180.0)};
  SeenLines seen;
  for (double y = 190.0; y <= 250.0; y += 10.0) {
    seen.lines.push_back({robotFromField(pose, {10.0, y}), 1.0, true});
    seen.lines.push_back({robotFromField(pose, {-88.0, y}), 1.0, true});
    seen.carpet.push_back({robotFromField(pose, {-40.0, y}), 1.0});
  }
  const auto match = [&](double outside) {
    const MatchTables tables(field2004(), features2004(), {MatchDecay::reciprocal, 0.004, outside});
    return overallMatch(seen, pose, tables, Interpolation::thesis).value;
  };
  EXPECT_NEAR(match(kSeenInLisbon), 1.0, 1e-4);
  const double wall = 1.0 / (1.0 + 0.004 * 98.0 * 98.0);
  EXPECT_NEAR(match(kSeenAtHome), 0.5 * (1.0 + wall) / 11.0, 1e-4);
}

TEST(MatchTable, SlopeIsThatOfTheOverallMatch) {
  const MatchTables tables(field2006(), features(), {});
  const SeenLines seen = seenFrom(kPose);
  const Pose2 pose{{158.0, 113.0}, Angle::deg(44.0)};
  for (const Interpolation how : {Interpolation::thesis, Interpolation::bilinear}) {
    const OverallMatch here = overallMatch(seen, pose, tables, how);
    const double h = 0.5;
    const auto match = [&](double x, double y) {
      return overallMatch(seen, {{158.0 + x, 113.0 + y}, pose.heading}, tables, how).value;
    };
    EXPECT_NEAR(here.slope(0), (match(h, 0) - match(-h, 0)) / (2 * h), 0.15 * 0.02);
    EXPECT_NEAR(here.slope(1), (match(0, h) - match(0, -h)) / (2 * h), 0.15 * 0.02);
  }
}

// All points were seen without noise, so that the match is 1 at the pose alone.
TEST(Ascent, ClimbsToThePose) {
  const MatchTables tables(field2006(), features(), {});
  const SeenLines seen = seenFrom(kPose);
  EXPECT_NEAR(overallMatch(seen, kPose, tables, Interpolation::thesis).value, 1.0, 0.02);
  const Ascent ascent = ascend(seen, {{158.0, 113.0}, Angle::deg(44.0)}, tables, {});
  EXPECT_NEAR(ascent.match, 1.0, 0.05);
  EXPECT_NEAR(ascent.pose.position.x, kPose.position.x, 2.0);
  EXPECT_NEAR(ascent.pose.position.y, kPose.position.y, 2.0);
  EXPECT_NEAR(ascent.pose.heading.deg(), kPose.heading.deg(), 1.0);
  EXPECT_LE(ascent.steps, 50U) << "thesis 2004 section 3.3.1";
}

}  // namespace
}  // namespace kelpie::gps
