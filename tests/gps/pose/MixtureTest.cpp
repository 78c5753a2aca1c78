// SPDX-License-Identifier: Apache-2.0
// What the mixture of poses becomes and what of it is published: the thesis' two pictures.
#include <gtest/gtest.h>

#include <cmath>

#include "gps/Extract.h"
#include "gps/Gaussian.h"
#include "gps/GpsParams.h"
#include "gps/GpsState.h"
#include "gps/pose/Modes.h"
#include "gps/pose/PoseUpdate.h"

namespace kelpie::gps {
namespace {

PoseMode modeAt(double weight, double x, double y, double sd) {
  PoseMode mode;
  mode.weight = weight;
  mode.pose = {{x, y}, Angle::deg(90)};
  mode.covariance = {sd * sd, 0, 0, 0, sd * sd, 0, 0, 0, 0.01};
  return mode;
}

// Thesis 2004 figure 2.5. Beacons at both sides, seen truly: each mode is drawn to the same place.
TEST(Mixture, FourEqualModesBecomeOneUnderTheSameSightings) {
  GpsParams params;
  params.field = *body::fieldDescription("2006");
  params.modes.wideWeight = 0.0;
  GpsState state;
  state.pose.lost = false;
  for (const double x : {150.0, 210.0})
    for (const double y : {210.0, 270.0}) state.pose.modes.push_back(modeAt(0.25, x, y, 40.0));
  for (int round = 0; round < 12; ++round) {
    for (const double side : {-15.0, 375.0}) {
      const Point2<Field> beacon{side, 405.0};
      const Expectation seen = expected({{180.0, 240.0}, Angle::deg(90)}, beacon);
      const Measurement m{beacon, true, true, seen.distance, seen.heading, 100.0, 0.004};
      updateAll(m, params.field, params.modes, state.pose, state.counts);
      mergeAndPrune(params.field, params.modes, state.pose, state.counts);
    }
  }
  ASSERT_FALSE(state.pose.modes.empty());
  EXPECT_GT(state.pose.modes[0].weight, 0.95);
  EXPECT_LT(distance(state.pose.modes[0].pose.position, {180.0, 240.0}), 3.0);
}

TEST(Mixture, FourEqualModesAreOneAtOnceAndKeepTheirPlaceAndWeight) {
  GpsParams params;
  params.field = *body::fieldDescription("2006");
  GpsState state;
  for (int i = 0; i < 4; ++i) state.pose.modes.push_back(modeAt(0.25, 150, 210, 20));
  mergeAndPrune(params.field, params.modes, state.pose, state.counts);
  ASSERT_EQ(state.pose.modes.size(), 1U);
  EXPECT_NEAR(state.pose.modes[0].weight, 1.0, 1e-12);
  EXPECT_EQ(state.pose.modes[0].pose.position.x, 150.0);
  EXPECT_NEAR(state.pose.modes[0].covariance[0], 400.0, 1e-9);
}

double density(const Modes& modes, Point2<Field> at) {
  double sum = 0.0;
  for (const PoseMode& mode : modes) {
    const Vector3 d(at.x - mode.pose.position.x, at.y - mode.pose.position.y, 0.0);
    const Matrix3 c = covarianceOf(mode);
    sum += mode.weight * std::exp(-0.5 * d.dot(c.inverse() * d)) / std::sqrt(c.determinant());
  }
  return sum;
}

// The highest point of the mixture, sought centimetre by centimetre.
Point2<Field> highest(const Modes& modes) {
  Point2<Field> best;
  for (double x = 0.0; x <= 360.0; x += 1.0)
    for (double y = 0.0; y <= 540.0; y += 1.0)
      if (density(modes, {x, y}) > density(modes, best)) best = {x, y};
  return best;
}

// The mean at which the mixture is highest (thesis 2004 equation 2.13).
Point2<Field> highestMean(const Modes& modes) {
  Point2<Field> best = modes[0].pose.position;
  for (const PoseMode& mode : modes)
    if (density(modes, mode.pose.position) > density(modes, best)) best = mode.pose.position;
  return best;
}

Point2<Field> published(const Modes& modes) {
  GpsState state;
  state.pose.modes = modes;
  return extract(state, {}).pose.position;
}

TEST(Mixture, ThePublishedPoseIsItsHighestPointWhereModesAreAlikeInWidth) {
  Modes modes;
  modes.push_back(modeAt(0.6, 100, 150, 15));
  modes.push_back(modeAt(0.4, 250, 400, 15));
  EXPECT_EQ(distance(published(modes), {100, 150}), 0.0);
  EXPECT_EQ(distance(highestMean(modes), published(modes)), 0.0);
  EXPECT_LT(distance(highest(modes), published(modes)), 1.0);
}

WorldModel believed(const Modes& modes) {
  GpsState state;
  state.pose.modes = modes;
  return extract(state, {});
}

TEST(Mixture, ThePublishedCovarianceKnowsOfTheOtherModes) {
  Modes modes;
  modes.push_back(modeAt(0.6, 100, 150, 15));
  EXPECT_EQ(believed(modes).covariance, modes[0].covariance);
  modes.push_back(modeAt(0.4, 100, 350, 15));
  const WorldModel world = believed(modes);
  EXPECT_NEAR(world.positionSd, std::sqrt(15.0 * 15.0 + 0.4 * 200.0 * 200.0), 1e-9);
  EXPECT_NEAR(world.covariance[0], 15.0 * 15.0, 1e-9);
}

// Thesis 2004 figure 2.6: half the weight on a narrow mode stands higher than the rest on a wide
// one.
TEST(Mixture, ThePublishedPoseIsTheHeaviestModesAndNotTheHighestPointInTheOddCase) {
  Modes modes;
  modes.push_back(modeAt(0.55, 100, 150, 60));
  modes.push_back(modeAt(0.45, 250, 400, 10));
  EXPECT_EQ(distance(published(modes), {100, 150}), 0.0);
  EXPECT_EQ(distance(highestMean(modes), {250, 400}), 0.0);
  EXPECT_LT(distance(highest(modes), {250, 400}), 1.0);
}

}  // namespace
}  // namespace kelpie::gps
