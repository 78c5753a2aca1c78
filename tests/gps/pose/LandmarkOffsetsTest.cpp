// SPDX-License-Identifier: Apache-2.0
// Landmarks that stand beside their place on the map: found from a robot that knows where it is.
#include <gtest/gtest.h>

#include <cmath>

#include "gps/Refusal.h"
#include "gps/pose/LandmarkOffsets.h"
#include "gps/pose/PoseUpdate.h"
#include "robot/core/Random.h"

namespace kelpie::gps {
namespace {

constexpr LandmarkKind kKind = LandmarkKind::goalBlue;

// A robot that knows its pose to 2 cm and 1 deg sees one landmark from many places.
struct Watcher {
  LandmarkOffsetParams params;
  LandmarkOffsets offsets;
  GpsCounts counts;
  Random random{7};
  Point2<Field> onMap{0.0, 300.0};

  Watcher() { offsets = startingOffsets(params); }

  static PoseMode modeAt(Point2<Field> place, double sd = 2.0) {
    PoseMode mode;
    mode.weight = 1.0;
    mode.pose = {place, Angle::deg(90.0)};
    mode.covariance = {sd * sd, 0, 0, 0, sd * sd, 0, 0, 0, 0.0003};
    return mode;
  }
  Measurement sighting(const PoseMode& mode, Point2<Field> stands) {
    const Expectation e = expected(mode.pose, stands);
    Measurement m;
    m.landmark = onMap;
    m.kind = kKind;
    m.useDistance = m.useHeading = true;
    m.distance = e.distance + random.gaussian(0.0, 4.0);
    m.heading = e.heading + Angle::rad(random.gaussian(0.0, 0.015));
    m.distanceVariance = 16.0;
    m.headingVariance = m.grazingHeadingVariance = 0.000225;
    return m;
  }
  void look(int frames, Point2<Field> stands, double sd = 2.0) {
    for (int i = 0; i < frames; ++i) {
      const PoseMode mode = modeAt({random.gaussian(0.0, 50.0), random.gaussian(120.0, 30.0)}, sd);
      const Measurement seen = displaced(sighting(mode, stands), params, offsets);
      learnOffset(mode, seen, params, offsets, counts);
    }
  }
  const LandmarkOffset& learnt() const {
    return offsets.landmarks[static_cast<std::size_t>(kKind)];
  }
  int told() const { return counts.refused[static_cast<std::size_t>(Refusal::landmarkMoved)]; }
};

TEST(LandmarkOffsets, OneThatWasPushedAsideIsFoundWhereItStandsAndTold) {
  Watcher robot;
  robot.look(200, {12.0, 300.0});
  EXPECT_NEAR(robot.learnt().x, 12.0, 3.0);
  EXPECT_NEAR(robot.learnt().y, 0.0, 3.0);
  EXPECT_GT(robot.told(), 100);
}

TEST(LandmarkOffsets, OneThatStandsWhereItShouldIsNotMovedAndNotTold) {
  Watcher robot;
  robot.look(200, {0.0, 300.0});
  EXPECT_NEAR(robot.learnt().x, 0.0, 1.5);
  EXPECT_NEAR(robot.learnt().y, 0.0, 1.5);
  EXPECT_EQ(robot.told(), 0);
}

TEST(LandmarkOffsets, ARobotThatHardlyKnowsItsPlaceSaysNothingOfThem) {
  Watcher robot;
  robot.look(200, {12.0, 300.0}, 30.0);
  EXPECT_EQ(robot.learnt().x, 0.0);
}

TEST(LandmarkOffsets, OtherTeamsFieldHasOtherLandmarks) {
  Watcher robot;
  robot.look(200, {12.0, 300.0});
  driftOffsets(TeamColour::blue, 0.03, robot.params, robot.offsets);
  EXPECT_EQ(robot.learnt().x, 0.0);
  EXPECT_EQ(std::sqrt(robot.learnt().xx), robot.params.sd);
}

TEST(LandmarkOffsets, DoubtOfThePlaceIsDoubtOfTheSighting) {
  Watcher robot;
  const Measurement seen = robot.sighting(Watcher::modeAt({0.0, 100.0}), robot.onMap);
  const Measurement doubted = gps::doubted(seen, robot.offsets);
  const double variance = robot.params.sd * robot.params.sd;
  EXPECT_DOUBLE_EQ(doubted.distanceVariance, seen.distanceVariance + variance);
  EXPECT_DOUBLE_EQ(doubted.headingVariance,
                   seen.headingVariance + variance / (seen.distance * seen.distance));
}

TEST(LandmarkOffsets, SwitchedOffTheyAreWhereTheMapHasThem) {
  Watcher robot;
  robot.params.use = false;
  robot.offsets = startingOffsets(robot.params);
  robot.look(200, {12.0, 300.0});
  EXPECT_EQ(robot.learnt().x, 0.0);
  EXPECT_EQ(robot.learnt().xx, 0.0);
}

}  // namespace
}  // namespace kelpie::gps
