// SPDX-License-Identifier: Apache-2.0
// Places that look the same, derived from the field's description.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "robot/core/Random.h"
#include "tests/gps/Field2004.h"
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

// The border's foot within so many cm of a place, seen from the pose.
SeenLines borderAround(const Pose2& pose, Point2<Field> place, double reach) {
  SeenLines seen;
  for (const body::BorderPiece& piece : body::borderOf(field2004())) {
    const Point2<Field> way = piece.foot.end - piece.foot.start;
    for (double at = 0.0; at <= way.norm(); at += 1.0) {
      const Point2<Field> p = piece.foot.start + way * (at / way.norm());
      if (distance(p, place) < reach) seen.lines.push_back({robotFromField(pose, p), 1.0, true});
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

TEST(PaintedFeatures, OfOsakaAreThoseOf2006) {
  const PaintedFeatures all = paintedFeatures(*body::fieldDescription("osaka2005"));
  EXPECT_EQ(countOf(all, FeatureKind::corner), 8U + 12U);
  EXPECT_EQ(countOf(all, FeatureKind::tee), 6U);
  EXPECT_EQ(countOf(all, FeatureKind::circle), 2U);
  EXPECT_EQ(countOf(all, FeatureKind::straight), 22U);
  EXPECT_EQ(countOf(all, FeatureKind::border) + countOf(all, FeatureKind::borderBend), 0U);
}

// Its boxes have four corners, and the border takes the place of all other crossings: it has two
// sides, two pieces beside each goal and four triangles, each with two bends.
TEST(PaintedFeatures, OfTheFieldOf2004HaveTheBorder) {
  const PaintedFeatures all = paintedFeatures(field2004());
  EXPECT_EQ(countOf(all, FeatureKind::corner), 4U);
  EXPECT_EQ(countOf(all, FeatureKind::tee), 0U);
  EXPECT_EQ(countOf(all, FeatureKind::circle), 2U);
  EXPECT_EQ(countOf(all, FeatureKind::straight), 18U);
  EXPECT_EQ(countOf(all, FeatureKind::border), 10U);
  EXPECT_EQ(countOf(all, FeatureKind::borderBend), 8U);
  EXPECT_FALSE(all.full());
}

// The border turns by 45 deg, so that its bisector is 67.5 deg from each of its arms.
TEST(PaintedFeatures, TheBorderBendsWhereItsTrianglesBegin) {
  struct Bend {
    double x;
    double y;
    double deg;
  };
  std::size_t found = 0;
  const PaintedFeatures all = paintedFeatures(field2004());
  for (const Bend& bend :
       {Bend{10, 60, 22.5}, Bend{60, 10, 67.5}, Bend{230, 10, 112.5}, Bend{280, 60, 157.5},
        Bend{280, 380, -157.5}, Bend{230, 430, -112.5}, Bend{60, 430, -67.5}, Bend{10, 380, -22.5}})
    for (const PaintedFeature& f : all) {
      if (f.kind != FeatureKind::borderBend || distance(f.place, {bend.x, bend.y}) > 0.1) continue;
      ++found;
      EXPECT_NEAR(f.direction.deg(), bend.deg, 1e-6) << bend.x << " " << bend.y;
    }
  EXPECT_EQ(found, 8U);
}

TEST(PaintedFeatures, TheBorderLooksIntoTheField) {
  for (const PaintedFeature& f : paintedFeatures(field2004())) {
    if (f.kind != FeatureKind::border) continue;
    const Point2<Field> ahead = f.place + Point2<Field>{f.direction.cos(), f.direction.sin()} * 5.0;
    EXPECT_TRUE(ahead.x > 10.0 && ahead.x < 280.0 && ahead.y > 10.0 && ahead.y < 430.0);
    EXPECT_GT(std::fabs(features2004().border(ahead).value), 4.99);
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

TEST(Symmetry, PosesBeforeEveryBendOfTheBorderSeeTheSame) {
  const PaintedFeatures all = paintedFeatures(field2004());
  Random random(5);
  for (const PaintedFeature& from : all) {
    if (from.kind != FeatureKind::borderBend) continue;
    const Pose2 pose{from.place + Point2<Field>{random.uniform(-80, 80), random.uniform(-80, 80)},
                     randomAngle(random)};
    const SeenLines seen = borderAround(pose, from.place, 18.0);
    ASSERT_NEAR(static_cast<double>(seen.lines.size()), 36.0, 2.0) << "18 points a side";
    for (const PaintedFeature& to : all) {
      if (to.kind != from.kind) continue;
      EXPECT_NEAR(lineMatch(seen, movedWithFeature(pose, from, to), features2004(), {}), 1.0, 0.02);
    }
  }
}

// Before the bend at (10, 60) as before the other seven, of which six are kept.
TEST(Symmetry, AViewOfABendOfTheBorderMayBeAnyOther) {
  const PaintedFeatures painted = paintedFeatures(field2004());
  const Pose2 pose{{70.0, 80.0}, Angle::deg(200)};
  const SeenLines seen = borderAround(pose, {10.0, 60.0}, 18.0);
  LineFit fit;
  fit.pose = pose;
  fit.match = 1.0;
  fit.information = Matrix3::Identity();
  const AmbiguousPoses poses = ambiguousPoses(seen, fit, {field2004(), features2004()}, painted,
                                              LineUpdateParams{}, SymmetryParams{});
  ASSERT_EQ(poses.size(), 6U);
  for (const AmbiguousPose& p : poses) {
    EXPECT_GT(p.match, 0.98);
    // From the bend the robot stands (60, 20) away, 63.2 cm; so it does from another.
    double nearest = 1e9;
    for (const PaintedFeature& f : painted)
      if (f.kind == FeatureKind::borderBend)
        nearest = std::min(nearest, std::fabs(distance(p.pose.position, f.place) - 63.246));
    EXPECT_LT(nearest, 0.01);
  }
}

// The left side of the border is seen: nothing is known along it, on the other side neither.
TEST(Symmetry, AlongAStraightPieceOfTheBorderNothingIsKnown) {
  const PaintedFeatures painted = paintedFeatures(field2004());
  const Pose2 pose{{60.0, 220.0}, Angle::deg(180)};
  LineFit fit;
  fit.pose = pose;
  fit.match = 1.0;
  fit.information = Matrix3::Identity();
  const AmbiguousPoses poses =
      ambiguousPoses(borderAround(pose, {10.0, 220.0}, 30.0), fit, {field2004(), features2004()},
                     painted, LineUpdateParams{}, SymmetryParams{});
  bool here = false;
  for (const AmbiguousPose& p : poses) {
    if (distance(p.pose.position, pose.position) > 1.0) continue;
    here = true;
    EXPECT_NEAR(p.information(0, 0), 1.0, 1e-9);
    EXPECT_NEAR(p.information(1, 1), 0.0, 1e-9);
  }
  EXPECT_TRUE(here);
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
