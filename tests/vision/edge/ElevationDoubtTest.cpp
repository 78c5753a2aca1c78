// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "tests/vision/Board.h"
#include "tests/vision/Painting.h"
#include "vision/ElevationDoubt.h"
#include "vision/Refusal.h"
#include "vision/Vision.h"
#include "vision/line/PointChecks.h"
#include "vision/robot/RobotPatch.h"

namespace kelpie::vision {
namespace {

constexpr double kStart = 1.5;  // deg, the sd of a robot's tilt at its start

CameraPose knownTo(CameraPose camera, double tiltDeg, double rollDeg) {
  const auto variance = [](double deg) { return std::pow(Angle::deg(deg).rad(), 2.0); };
  camera.tilt.tiltVariance = variance(tiltDeg);
  camera.tilt.rollVariance = variance(rollDeg);
  return camera;
}

// A camera 16 cm high that looks ahead, taken for one that looks `error` deg higher or lower.
Percepts seen(const Painting& painting, double error, double sd) {
  const auto input = std::make_unique<FrameInput>();
  paint(painting, cameraAt(16, 0, 0), input->image);
  const auto state = stateForPaintings();
  const CameraPose believed = knownTo(cameraAt(16, 0, error), sd, sd);
  return step({*input, bodyOf(believed)}, {}, *state);
}

int refused(const Percepts& percepts, Refusal reason) {
  return percepts.counts.refused[static_cast<std::size_t>(reason)];
}

TEST(ElevationDoubt, InSettledPlayAndBetterKnownAnErrorCountsAsItIs) {
  const CameraPose camera = cameraAt(16, 0, 0);
  for (const double sd : {0.02, 0.29}) {
    const ElevationDoubt doubt = elevationDoubt(knownTo(camera, sd, sd), {0.0, 1.0, 0.0});
    EXPECT_EQ(doubt.spread, 1.0);
    EXPECT_EQ(doubt.slack(), 0.0);
  }
}

TEST(ElevationDoubt, AtARobotsStartTwoDegreesCountAsHalfADegree) {
  const ElevationDoubt doubt =
      elevationDoubt(knownTo(cameraAt(16, 0, 0), kStart, kStart), {0.0, 1.0, 0.0});
  EXPECT_NEAR(2.0 / doubt.spread, 0.55, 0.05);
  EXPECT_NEAR(Angle::rad(doubt.slack()).deg(), 2.0 * 1.47, 0.01);
}

TEST(ElevationDoubt, ABadlyKnownRollIsOfNoConcernAhead) {
  const CameraPose camera = knownTo(cameraAt(16, 0, 0), 0.29, kStart);
  EXPECT_EQ(elevationDoubt(camera, {0.0, 1.0, 0.0}).spread, 1.0);
  EXPECT_GT(elevationDoubt(camera, {1.0, 0.0, 0.0}).spread, 3.0);
}

TEST(ElevationDoubt, ABeaconTwoDegreesOffIsRefusedOnlyWhereTheTiltIsKnown) {
  Painting p;
  p.carpetEnd = 200;
  p.beacons.push_back({{0, 200}, kPinkPaint, kYellowPaint});
  for (const double error : {-2.0, 2.0}) {
    const Percepts settled = seen(p, error, 0.3);
    EXPECT_EQ(find(settled, LandmarkKind::beaconPinkOnYellow), nullptr) << error;
    EXPECT_GE(refused(settled, Refusal::beaconElevation), 1) << error;
    const Percepts starting = seen(p, error, kStart);
    const LandmarkPercept* beacon = find(starting, LandmarkKind::beaconPinkOnYellow);
    ASSERT_NE(beacon, nullptr) << error;
    EXPECT_NEAR(beacon->distance, 200, 8);
    EXPECT_NEAR(beacon->elevationError.value.deg(), error, 0.4);
  }
}

TEST(ElevationDoubt, ABeaconThatHoversByFarMoreIsRefusedAnyhow) {
  Painting p;
  p.carpetEnd = 200;
  p.beacons.push_back({{0, 200}, kPinkPaint, kYellowPaint});
  EXPECT_EQ(find(seen(p, -8.0, kStart), LandmarkKind::beaconPinkOnYellow), nullptr);
}

TEST(ElevationDoubt, AGoalWhoseFeetAreTwoDegreesOffIsSeenWhereTheTiltIsNotKnown) {
  Painting p;
  p.carpetEnd = 330;
  addGoal(p, 0, 300, kBluePaint);
  for (const double error : {-2.5, 2.5}) {
    EXPECT_EQ(find(seen(p, error, 0.3), LandmarkKind::goalBlue), nullptr) << error;
    const Percepts starting = seen(p, error, kStart);
    const LandmarkPercept* goal = find(starting, LandmarkKind::goalBlue);
    ASSERT_NE(goal, nullptr) << error;
    EXPECT_NEAR(goal->distance, 300, 15) << error;
  }
}

TEST(ElevationDoubt, ABallsDistanceLeansOnItsSizeWhereTheTiltIsNotKnown) {
  Painting p;
  p.balls.push_back({0.0, 208.0});
  const auto off = [&](double sd) { return std::fabs(seen(p, 2.0, sd).ball.distance - 208.0); };
  EXPECT_LT(off(kStart), 0.6 * off(0.3));
}

TEST(ElevationDoubt, ALineOfTheWrongWidthMayBeOneWhereTheTiltIsNotKnown) {
  const LinePointParams p;
  GroundWidth width{0.5, 5.0, 0.0};
  EXPECT_FALSE(lineIsNarrow(width, 2.5, p));
  width.doubt = 1.0;
  EXPECT_TRUE(lineIsNarrow(width, 2.5, p));
  width.paint = 0.4;
  EXPECT_TRUE(lineIsWide(width, 2.5, p));
}

TEST(ElevationDoubt, ARobotsPatchMayHangHigherWhereTheTiltIsNotKnown) {
  RobotPatch patch;
  patch.foot.end = FootEnd::carpet;
  patch.height = 30.0;
  EXPECT_FALSE(robotStandsOnGround(patch, {}));
  patch.heightSd = 4.0;
  EXPECT_TRUE(robotStandsOnGround(patch, {}));
  patch.height = 34.0;
  EXPECT_FALSE(robotStandsOnGround(patch, {}));
}

TEST(ElevationDoubt, RowsByTheHorizonAreWiderByTwoStandardDeviations) {
  Board board(knownTo(cameraAt(16, 0, 0), 0.3, 0.3));
  EXPECT_NEAR(rowSlack(board.scene()), 0.0, 0.3);
  board.body.camera = knownTo(cameraAt(16, 0, 0), kStart, 0.3);
  EXPECT_NEAR(rowSlack(board.scene()), 2.0 * 192.0 * Angle::deg(1.47).rad(), 0.1);
}

}  // namespace
}  // namespace kelpie::vision
