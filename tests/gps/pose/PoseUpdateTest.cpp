// SPDX-License-Identifier: Apache-2.0
// The update of a mode in information form: equal to the textbook's filter for a landmark and for
// an observed pose, and to one update after the other for several.
#include <gtest/gtest.h>

#include "gps/pose/PoseUpdate.h"
#include "robot/core/Random.h"
#include "tests/gps/pose/ModeAndMeasurement.h"

namespace kelpie::gps {
namespace {

const Pose2 kPose{{150.0, 120.0}, Angle::deg(40.0)};

PoseMode someMode() {
  PoseMode mode = modeAt(150.0, 220.0, 170.0 * maths::kPi / 180.0);
  mode.weight = 0.7;
  return mode;
}

PoseObservation poseSeen(double x, double y, double deg, double scale) {
  Matrix3 y3;
  y3 << 0.05, 0.01, 0.2, 0.01, 0.02, 0.1, 0.2, 0.1, 30.0;
  return {{{x, y}, Angle::deg(deg)}, scale * y3};
}

void expectSame(const PoseMode& a, const PoseMode& b) {
  EXPECT_NEAR(a.weight / b.weight, 1.0, 1e-9);
  EXPECT_NEAR(distance(a.pose.position, b.pose.position), 0.0, 1e-9);
  EXPECT_NEAR((a.pose.heading - b.pose.heading).rad(), 0.0, 1e-11);
  for (std::size_t i = 0; i < 9; ++i) EXPECT_NEAR(a.covariance[i], b.covariance[i], 1e-8);
}

TEST(PoseUpdate, JacobianMatchesDifferences) {
  const Point2<Field> landmark{375, 405};
  const Pose2 pose{{100, 200}, Angle::rad(2.9)};
  const Expectation e = expected(pose, landmark);
  constexpr double kStep = 1e-5;
  for (int i = 0; i < 3; ++i) {
    Pose2 other = pose;
    if (i == 0) other.position.x += kStep;
    if (i == 1) other.position.y += kStep;
    if (i == 2) other.heading = Angle::rad(2.9 + kStep);
    const Expectation f = expected(other, landmark);
    const auto column = static_cast<std::size_t>(i);
    EXPECT_NEAR(e.jacobian[column], (f.distance - e.distance) / kStep, 1e-6);
    EXPECT_NEAR(e.jacobian[3 + column], (f.heading - e.heading).rad() / kStep, 1e-6);
  }
}

double varianceOf(const PoseMode& mode, const double* jacobianRow) {
  const Vector3 h(jacobianRow[0], jacobianRow[1], jacobianRow[2]);
  return h.dot(covarianceOf(mode) * h);
}

TEST(PoseUpdate, ALandmarkWeighsAModeByTheDensityOfWhatWasSeen) {
  const PoseMode mode = someMode();
  const Measurement m = seenAt({375, 405}, 300, -0.4);
  const Expectation e = expected(mode.pose, m.landmark);
  Eigen::Matrix<double, 2, 3> h;
  for (int i = 0; i < 6; ++i) h(i / 3, i % 3) = e.jacobian[static_cast<std::size_t>(i)];
  const Matrix2 r = Vector2(400, 0.004).asDiagonal();
  const Matrix2 s = h * covarianceOf(mode) * h.transpose() + r;
  const Vector2 nu(300 - e.distance, (m.heading - e.heading).rad());
  const double density = std::exp(-0.5 * nu.dot(s.inverse() * nu)) / std::sqrt(s.determinant());
  const double factor = correctedByLandmark(mode, m).weight / mode.weight;
  EXPECT_NEAR(factor / (density * std::sqrt(r.determinant())), 1.0, 1e-9);
}

TEST(PoseUpdate, AModeAtAGrazingAnglePaysAsForAllOfASightingThatFits) {
  const PoseMode mode = someMode();
  const Expectation e = expected(mode.pose, {375, 405});
  Measurement m = seenAt({375, 405}, e.distance, e.heading.rad());
  m.grazingHeadingVariance = 0.07;
  const double elsewhere = correctedByLandmark(mode, m).weight;
  m.minGoalLineDistance = 300.0;
  const PoseMode grazing = correctedByLandmark(mode, m);
  EXPECT_NEAR(grazing.weight, 0.5 * elsewhere, 1e-9);
  EXPECT_GT(varianceOf(grazing, e.jacobian.data()), 0.99 * varianceOf(mode, e.jacobian.data()));
}

// The textbook's form, with another inverse and without Joseph's, on the same numbers.
TEST(PoseUpdate, ALandmarkEqualsATextbookFilter) {
  PoseMode mode = modeAt(150, 220, 1.2);
  const Measurement m = seenAt({375, 405}, 300, -0.4);
  const double dx = 225, dy = 185, r = std::sqrt(dx * dx + dy * dy);
  Eigen::Matrix<double, 2, 3> h;
  h << -dx / r, -dy / r, 0, dy / (r * r), -dx / (r * r), -1;
  const Matrix3 p = covarianceOf(mode);
  const Matrix2 s = h * p * h.transpose() + Vector2(400, 0.004).asDiagonal().toDenseMatrix();
  const Eigen::Matrix<double, 3, 2> k = (s.ldlt().solve(h * p)).transpose();
  const Vector2 innovation(300 - r, -0.4 - (std::atan2(dy, dx) - 1.2));
  const Vector3 mean = Vector3(150, 220, 1.2) + k * innovation;
  const Matrix3 covariance = (Matrix3::Identity() - k * h) * p;
  mode = corrected(mode, m);
  EXPECT_LT((meanOf(mode) - mean).norm(), 1e-9);
  EXPECT_LT((covarianceOf(mode) - covariance).norm(), 1e-8);
  const double likelihood = std::exp(-0.5 * innovation.dot(s.ldlt().solve(innovation)));
  EXPECT_NEAR(mode.weight, likelihood, 1e-12);
}

TEST(PoseUpdate, NeverGrowsTheTraceAndStaysPositive) {
  Random random(7);
  for (int i = 0; i < 500; ++i) {
    PoseMode mode = modeAt(random.uniform(0, 360), random.uniform(0, 540), random.uniform(-3, 3));
    const double before = covarianceOf(mode).trace();
    mode = corrected(mode, seenAt({-15, 135}, random.uniform(20, 500), random.uniform(-3, 3)));
    EXPECT_LE(covarianceOf(mode).trace(), before);
    EXPECT_GT(covarianceOf(mode).selfadjointView<Eigen::Lower>().eigenvalues().minCoeff(), 0.0);
    EXPECT_LE(mode.weight, 1.0);
    EXPECT_EQ(mode.covariance[1], mode.covariance[3]);
  }
}

TEST(PoseUpdate, PerfectForecastKeepsTheWeight) {
  PoseMode mode = modeAt(0, 0, 0);
  mode = corrected(mode, seenAt({30, 40}, 50, std::atan2(40.0, 30.0)));
  EXPECT_NEAR(mode.weight, 1.0, 1e-12);
}

TEST(PoseUpdate, AModeThatStandsOnTheLandmarkLosesItsWeightAndStays) {
  PoseMode mode = modeAt(178, 541, 0.7);
  const PoseMode before = mode;
  mode = corrected(mode, seenAt({180, 540}, 150, 0.2));
  EXPECT_LT(mode.weight, 1e-6 * before.weight);
  EXPECT_GT(mode.weight, 0.0);
  EXPECT_EQ(mode.pose.position.x, before.pose.position.x);
  EXPECT_EQ(mode.covariance, before.covariance);
}

TEST(PoseUpdate, APoseObservedEqualsATextbookFilter) {
  PoseMode mode = modeAt(kPose.position.x, kPose.position.y, kPose.heading.rad());
  const Vector3 before = meanOf(mode);
  const Matrix3 p = covarianceOf(mode);
  Matrix3 r;
  r << 20, 3, 0, 3, 30, 0.01, 0, 0.01, 0.002;
  const Vector3 shift(5.0, -8.0, 0.1);
  const Matrix3 gain = p * (p + r).inverse();
  mode = corrected(mode, PoseObservation{poseOf(before + shift), r.inverse()});
  EXPECT_TRUE(meanOf(mode).isApprox(before + gain * shift, 1e-9));
  EXPECT_TRUE(covarianceOf(mode).isApprox(p - gain * p, 1e-9));
  EXPECT_NEAR(mode.weight, std::exp(-0.5 * shift.dot((p + r).inverse() * shift)), 1e-9);
}

TEST(PoseUpdate, LeavesTheDirectionOfWhichNothingIsKnown) {
  PoseMode mode = modeAt(kPose.position.x, kPose.position.y, kPose.heading.rad());
  mode.covariance = {400, 0, 0, 0, 250, 0, 0, 0, 0.05};
  Matrix3 information = Matrix3::Zero();
  information(0, 0) = 0.1;
  mode = corrected(mode, PoseObservation{{{170.0, 500.0}, kPose.heading}, information});
  EXPECT_GT(mode.pose.position.x, 169.0);
  EXPECT_EQ(mode.pose.position.y, kPose.position.y);
  EXPECT_NEAR(mode.covariance[4], 250.0, 1e-9);
}

TEST(PoseUpdate, OneUpdateIsTwoWhereAllIsLinear) {
  const PoseObservation first = poseSeen(158.0, 214.0, -179.0, 1.0);
  const PoseObservation second = poseSeen(147.0, 226.0, 165.0, 0.4);
  const PoseMode two = corrected(corrected(someMode(), first), second);
  InformationSum information;
  information.add(someMode(), first);
  information.add(someMode(), second);
  expectSame(corrected(someMode(), information), two);
}

// Variance 4 along x, seen at +2 with variance 4: half the way, half the variance,
// S = exp(-4 / (2 * 8)).
TEST(PoseUpdate, AHandMadeCase) {
  PoseMode mode;
  mode.weight = 1.0;
  mode.covariance = {4, 0, 0, 0, 4, 0, 0, 0, 0.01};
  PoseObservation seen;
  seen.pose = {{2.0, 0.0}, Angle()};
  seen.information = Vector3(0.25, 0.0, 0.0).asDiagonal();
  InformationSum information;
  information.add(mode, seen);
  const PoseMode after = corrected(mode, information);
  EXPECT_NEAR(after.pose.position.x, 1.0, 1e-12);
  EXPECT_NEAR(after.pose.position.y, 0.0, 1e-12);
  EXPECT_NEAR(after.covariance[0], 2.0, 1e-12);
  EXPECT_NEAR(after.covariance[4], 4.0, 1e-12);
  EXPECT_NEAR(after.weight, std::exp(-0.25), 1e-12);
}

// Where all is linear it does not matter where it is linearised: a heading far from the landmark.
TEST(PoseUpdate, LinearisedElsewhereTheSameObservationSaysNearlyTheSame) {
  Measurement seen{{1e6, 220.0}, false, true, 1e6, Angle::deg(-165.0), 1.0, 0.004};
  InformationSum here;
  here.add(someMode(), seen, someMode().pose);
  InformationSum there;
  there.add(someMode(), seen, {{170.0, 200.0}, Angle::deg(155.0)});
  const PoseMode a = corrected(someMode(), here);
  const PoseMode b = corrected(someMode(), there);
  EXPECT_NEAR((a.pose.heading - b.pose.heading).rad(), 0.0, 1e-4);
  EXPECT_NEAR(a.weight, b.weight, 1e-4);
}

TEST(PoseUpdate, AModeOnALandmarkKeepsItsPlaceAndLosesItsWeight) {
  const Measurement seen{someMode().pose.position, true, true, 50.0, Angle(), 400.0, 0.004};
  InformationSum information;
  information.add(someMode(), seen, someMode().pose);
  const PoseMode after = corrected(someMode(), information);
  EXPECT_EQ(after.pose.position.x, someMode().pose.position.x);
  EXPECT_LT(after.weight, 1e-19);
}

}  // namespace
}  // namespace kelpie::gps
