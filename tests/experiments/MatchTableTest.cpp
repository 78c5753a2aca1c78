// SPDX-License-Identifier: Apache-2.0
// The thesis' own way to the lines: the table of match values and the ascent on it.
#include <gtest/gtest.h>

#include "tests/gps/Field2006.h"
#include "tools/experiments/baselines/MatchTable.h"

namespace kelpie::gps {
namespace {

TEST(MatchTable, HasTheThesisSizeAndValues) {
  const MatchTables tables(field2006(), features(), 0.004);
  EXPECT_EQ(tables.lines.bytes(), 714400U);
  const auto at = [&tables](double x, double y, Interpolation how) {
    return tables.lines.at({x, y}, how).value;
  };
  const double d = std::fabs(features().nearest({60.0, 280.0}).value);
  EXPECT_NEAR(at(60.0, 280.0, Interpolation::thesis), 1.0 / (1.0 + 0.004 * d * d), 1e-6);
  EXPECT_NEAR(at(60.0, 280.0, Interpolation::bilinear), 1.0 / (1.0 + 0.004 * d * d), 1e-6);
  EXPECT_NEAR(at(61.3, 283.1, Interpolation::thesis), at(61.3, 283.1, Interpolation::bilinear),
              0.01);
}

TEST(MatchTable, SlopeIsThatOfTheOverallMatch) {
  const MatchTables tables(field2006(), features(), 0.004);
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

TEST(Ascent, ClimbsAndEndsNearThePose) {
  const MatchTables tables(field2006(), features(), 0.004);
  const SeenLines seen = seenFrom(kPose);
  const Pose2 start{{158.0, 113.0}, Angle::deg(44.0)};
  const double before = overallMatch(seen, start, tables, Interpolation::thesis).value;
  const Ascent ascent = ascend(seen, start, tables, {});
  EXPECT_GT(ascent.match, before + 0.1);
  EXPECT_LT(distance(ascent.pose.position, kPose.position), 5.0);
}

}  // namespace
}  // namespace kelpie::gps
