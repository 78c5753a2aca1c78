// SPDX-License-Identifier: Apache-2.0
// The foot of the white border, which the field of 2004 has instead of side lines.
#include <gtest/gtest.h>

#include "gps/lines/LineMap.h"
#include "gps/lines/LineUpdate.h"
#include "tests/gps/Field2004.h"
#include "tests/gps/Field2006.h"

namespace kelpie::gps {
namespace {

const Pose2 kInTheCorner{{70.0, 90.0}, Angle::deg(200.0)};

// Feet of the border up to 150 cm ahead, without noise, as vision gives them.
FixedVector<LinePoint, 256> borderSeenFrom(const Pose2& pose) {
  FixedVector<LinePoint, 256> points;
  for (const body::BorderPiece& piece : body::borderOf(field2004())) {
    const Point2<Field> way = piece.foot.end - piece.foot.start;
    for (double at = 0.0; at < way.norm(); at += 8.0) {
      const Point2<Robot> p = robotFromField(pose, piece.foot.start + way * (at / way.norm()));
      if (p.y > 0.0 && p.norm() < 150.0) points.push_back({LinePointKind::border, p, 1.0, {}});
    }
  }
  return points;
}

TEST(Border, ItsFootIsAsFarAsTheNearestPiece) {
  EXPECT_NEAR(std::fabs(features2004().border({40.0, 220.0}).value), 30.0, 1e-9);
  EXPECT_NEAR(std::fabs(features2004().border({35.0, 35.0}).value), 0.0,
              1e-9);  // a triangle's foot
  EXPECT_NEAR(std::fabs(features2004().border({145.0, 10.0}).value), 30.0, 1e-9);  // a goal's mouth
}

TEST(Border, ItsPointsMatchNothingOnAFieldWithoutOne) {
  const SeenLines seen = seenLines(borderSeenFrom(kInTheCorner), LineUpdateParams{});
  EXPECT_LT(lineMatch(seen, kInTheCorner, features(), {}), 1e-6);
}

TEST(Border, ItsPointsMatchAtTheTruePoseOnly) {
  const SeenLines seen = seenLines(borderSeenFrom(kInTheCorner), LineUpdateParams{});
  ASSERT_GT(seen.lines.size(), 15U);
  EXPECT_GT(lineMatch(seen, kInTheCorner, features2004(), {}), 0.99);
  const Pose2 lateral{{95.0, 90.0}, Angle::deg(200.0)};
  EXPECT_LT(lineMatch(seen, lateral, features2004(), {}), 0.7);
}

TEST(Border, ACornerOfItCorrectsThePose) {
  const SeenLines seen = seenLines(borderSeenFrom(kInTheCorner), LineUpdateParams{});
  const LineFit fit = fitLines(seen, {{80.0, 80.0}, Angle::deg(194.0)}, features2004(), {});
  EXPECT_LT(distance(fit.pose.position, kInTheCorner.position), 0.5);
  EXPECT_LT((fit.pose.heading - kInTheCorner.heading).abs().deg(), 0.3);
}

TEST(Border, LinesAndBorderAreMatchedEachWithItsOwn) {
  FixedVector<LinePoint, 256> points = borderSeenFrom(kInTheCorner);
  for (LinePoint& point : points) point.kind = LinePointKind::line;  // mistaken for a line
  const SeenLines seen = seenLines(points, LineUpdateParams{});
  EXPECT_LT(lineMatch(seen, kInTheCorner, features2004(), {}), 0.5);
}

TEST(Border, AStandingRobotsMapGivesItsPointsBack) {
  LinesParams params;
  LineMap map;
  stepMap(FrameInput{}, borderSeenFrom(kInTheCorner), params, map);
  const SeenLines seen = seenLines(map, 40, params.map);
  ASSERT_GT(seen.lines.size(), 5U);
  for (const SeenPoint& point : seen.lines) EXPECT_TRUE(point.border);
  EXPECT_EQ(seen.newEvidenceShare, 1.0);
}

}  // namespace
}  // namespace kelpie::gps
