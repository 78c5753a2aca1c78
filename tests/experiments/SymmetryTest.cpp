// SPDX-License-Identifier: Apache-2.0
// Places that look the same, derived from the field's description.
#include <gtest/gtest.h>

#include "robot/core/Random.h"
#include "tests/gps/Field2006.h"
#include "tools/experiments/baselines/Symmetry.h"

namespace kelpie::gps {
namespace {

std::size_t countOf(const PaintedFeatures& all, FeatureKind kind) {
  std::size_t count = 0;
  for (const PaintedFeature& f : all) count += f.kind == kind ? 1 : 0;
  return count;
}

Angle randomAngle(Random& random) { return Angle::rad(random.uniform(-maths::kPi, maths::kPi)); }

// Paint within 18 cm of a place, seen from the pose.
SeenLines seenAround(const Pose2& pose, Point2<Field> place) {
  SeenLines seen;
  for (const body::FieldLine& line : field2006().lines) {
    const Point2<Field> way = line.end - line.start;
    for (double at = 0.0; at <= way.norm(); at += 2.0) {
      const Point2<Field> p = line.start + way * (at / way.norm());
      if (distance(p, place) < 18.0) seen.lines.push_back({robotFromField(pose, p), 1.0});
    }
  }
  return seen;
}

TEST(PaintedFeatures, OfTheFieldOf2006) {
  const PaintedFeatures all = paintedFeatures(field2006());
  // Four corners of the field, four of the boxes, and two in each of the six Ts.
  EXPECT_EQ(countOf(all, FeatureKind::corner), 8U + 12U);
  EXPECT_EQ(countOf(all, FeatureKind::tee), 6U);
  EXPECT_EQ(countOf(all, FeatureKind::circle), 2U);
  EXPECT_EQ(countOf(all, FeatureKind::straight), 22U);
}

TEST(PaintedFeatures, OfTheOtherFields) {
  for (const char* name : {"osaka2005", "2004"}) {
    const PaintedFeatures all = paintedFeatures(*body::fieldDescription(name));
    EXPECT_EQ(countOf(all, FeatureKind::circle), 2U) << name;
    EXPECT_GE(countOf(all, FeatureKind::corner), 4U) << name;
    EXPECT_FALSE(all.full()) << name;
  }
}

TEST(PaintedFeatures, AreAbsentWithoutPaint) {
  body::FieldDescription bare;
  bare.circleDiameter = 0.0;
  bare.lines.clear();
  bare.lines.push_back({{1.0, 1.0}, {1.0, 1.0}});
  EXPECT_TRUE(paintedFeatures(bare).empty());
}

TEST(Symmetry, TwinOfATwinIsThePose) {
  Random random(2);
  for (int i = 0; i < 50; ++i) {
    const Pose2 pose{{random.uniform(0, 360), random.uniform(0, 540)}, randomAngle(random)};
    const Pose2 again = twinOf(twinOf(pose, field2006()), field2006());
    EXPECT_LT(distance(again.position, pose.position), 1e-9);
    EXPECT_LT((again.heading - pose.heading).abs().rad(), 1e-9);
    EXPECT_GT(distance(twinOf(pose, field2006()).position, pose.position) +
                  (twinOf(pose, field2006()).heading - pose.heading).abs().deg(),
              100.0);
  }
}

TEST(Symmetry, PosesOfOneKindSeeTheSame) {
  const PaintedFeatures all = paintedFeatures(field2006());
  Random random(8);
  for (const PaintedFeature& from : all) {
    if (from.kind != FeatureKind::tee) continue;
    const Pose2 pose{from.place + Point2<Field>{random.uniform(-80, 80), random.uniform(-80, 80)},
                     randomAngle(random)};
    const SeenLines seen = seenAround(pose, from.place);
    ASSERT_GT(seen.lines.size(), 20U);
    const double own = lineMatch(seen, pose, features(), {});
    EXPECT_GT(own, 0.98);
    for (const PaintedFeature& to : all) {
      if (to.kind != from.kind) continue;
      EXPECT_NEAR(lineMatch(seen, movedWithFeature(pose, from, to), features(), {}), own, 0.02);
    }
  }
}

TEST(Symmetry, CornersThatAreNoPartOfATSeeTheSame) {
  const PaintedFeatures all = paintedFeatures(field2006());
  const PaintedFeature from = all[0];  // of the own goal line, left
  ASSERT_EQ(from.kind, FeatureKind::corner);
  const Pose2 pose{from.place + Point2<Field>{50.0, 70.0}, Angle::deg(230)};
  const SeenLines seen = seenAround(pose, from.place);
  for (const PaintedFeature& to : all) {
    if (to.kind != FeatureKind::corner) continue;
    EXPECT_GT(lineMatch(seen, movedWithFeature(pose, from, to), features(), {}), 0.97);
  }
}

TEST(Symmetry, CovarianceTurnsWithThePose) {
  Matrix3 c;
  c << 100, 0, 1, 0, 4, 0, 1, 0, 0.1;
  const Matrix3 square = turned(c, Angle::deg(90));
  EXPECT_NEAR(square(0, 0), 4.0, 1e-9);
  EXPECT_NEAR(square(1, 1), 100.0, 1e-9);
  EXPECT_NEAR(square(1, 2), 1.0, 1e-9);
  EXPECT_NEAR(square(2, 2), 0.1, 1e-12);
  EXPECT_TRUE(turned(turned(c, Angle::deg(33)), Angle::deg(-33)).isApprox(c, 1e-9));
}

TEST(Symmetry, NothingIsKnownAlongAStraightPiece) {
  Matrix3 information;
  information << 1, 0.2, 3, 0.2, 2, 1, 3, 1, 400;
  const Angle along = Angle::deg(30);
  const Matrix3 left = withoutAlong(information, along);
  const Vector3 u(along.cos(), along.sin(), 0.0);
  EXPECT_LT((left * u).norm(), 1e-9);
  // It is the limit of adding variance along the piece.
  const Matrix3 wide = (information.inverse() + 1e9 * u * u.transpose()).inverse();
  EXPECT_TRUE(left.isApprox(wide, 1e-4));
}

TEST(Symmetry, AmbiguousPosesAreTheTwinAndThoseThatMatch) {
  const PaintedFeatures painted = paintedFeatures(field2006());
  const Pose2 pose{{60.0, 80.0}, Angle::deg(225)};  // before a corner
  const SeenLines seen = seenAround(pose, painted[0].place);
  LineFit fit = fitLines(seen, pose, features(), {});
  const AmbiguousPoses poses = ambiguousPoses(seen, fit, {field2006(), features()}, painted,
                                              LineUpdateParams{}, SymmetryParams{});
  ASSERT_EQ(poses.size(), kMaxAmbiguousPoses);
  bool twin = false;
  for (const AmbiguousPose& p : poses) {
    EXPECT_GT(lineMatch(seen, p.pose, features(), {}), 0.95);
    twin = twin || distance(p.pose.position, twinOf(fit.pose, field2006()).position) < 1e-6;
  }
  EXPECT_TRUE(twin);
}

}  // namespace
}  // namespace kelpie::gps
