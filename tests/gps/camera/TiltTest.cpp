// SPDX-License-Identifier: Apache-2.0
// The camera's tilt and roll beside the pose: what landmarks, lines and gravity say of them, and
// what the lines say of the pose while they are not known.
#include <gtest/gtest.h>

#include <cmath>

#include "gps/Refusal.h"
#include "gps/camera/EdgeElevation.h"
#include "gps/lines/LineUpdate.h"
#include "gps/pose/Modes.h"
#include "robot/body/Camera.h"
#include "tests/gps/Field2006.h"

namespace kelpie::gps {
namespace {

constexpr double kDegree = maths::kPi / 180.0;

// A robot that knows its pose and sees things too low.
struct Watcher {
  TiltParams params;
  PoseState state;
  FrameInput input;
  Percepts percepts;
  CameraPose camera;
  GpsCounts counts;

  Watcher() {
    PoseMode mode;
    mode.weight = 1.0;
    mode.pose = kPose;
    mode.covariance = {9, 0, 0, 0, 9, 0, 0, 0, 0.002};
    mode.tilt = startingTilt(params);
    state.modes.push_back(mode);
  }
  void look() {
    useTiltSightings(elevationSightings({input, percepts, camera}, params), camera.tilt, params,
                     state.modes, counts);
  }
  void seeBeacon(double heading, double tooLow, int times) {
    LandmarkPercept beacon;
    beacon.heading = Angle::deg(heading);
    beacon.elevationError = {Angle::deg(-tooLow), std::pow(0.2 * kDegree, 2)};
    percepts.landmarks.clear();
    percepts.landmarks.push_back(beacon);
    for (int i = 0; i < times; ++i) look();
  }
  const CameraTilt& tilt() const { return state.modes[0].tilt; }
};

TEST(Tilt, ALowBeaconAheadIsTiltAndOneToTheLeftIsRoll) {
  Watcher ahead;
  ahead.seeBeacon(0.0, 2.0, 10);
  EXPECT_NEAR(ahead.tilt().tilt.deg(), 2.0, 0.1);
  EXPECT_NEAR(ahead.tilt().roll.deg(), 0.0, 1e-9);
  Watcher lateral;
  lateral.seeBeacon(90.0, 2.0, 10);
  EXPECT_NEAR(lateral.tilt().roll.deg(), 2.0, 0.1);
  EXPECT_NEAR(lateral.tilt().tilt.deg(), 0.0, 1e-6);
}

// The next image is read with the new tilt: then the beacon stands where it should.
TEST(Tilt, AnErrorCountsFromTheTiltThatTheImageWasReadWith) {
  Watcher robot;
  robot.seeBeacon(0.0, 2.0, 10);
  robot.camera.tilt = robot.tilt();
  robot.seeBeacon(0.0, 2.0 - robot.tilt().tilt.deg(), 10);
  EXPECT_NEAR(robot.tilt().tilt.deg(), 2.0, 0.1);
}

TEST(Tilt, AnElevationThatNoTiltExplainsIsCountedAndChangesNothing) {
  Watcher robot;
  robot.seeBeacon(0.0, 9.0, 1);
  EXPECT_EQ(robot.tilt().tilt.deg(), 0.0);
  EXPECT_EQ(robot.counts.refused[static_cast<std::size_t>(Refusal::tiltUnlikely)], 1);
}

TEST(Tilt, WhatIsKnownFadesToHowMuchRobotsDiffer) {
  Watcher robot;
  robot.seeBeacon(0.0, 1.0, 50);
  const double known = robot.tilt().tiltVariance;
  driftTilt(1.0, 0.0, robot.params, robot.state.modes);
  EXPECT_NEAR(robot.tilt().tiltVariance - known, std::pow(robot.params.driftSd.rad(), 2), 1e-9);
  driftTilt(1e4, 0.0, robot.params, robot.state.modes);
  EXPECT_NEAR(std::sqrt(robot.tilt().tiltVariance), robot.params.initialSd.rad(), 1e-9);
}

TEST(Tilt, AShakenBodysTiltIsAnotherInTheNextImage) {
  Watcher robot;
  robot.seeBeacon(0.0, 1.0, 50);
  const double known = robot.tilt().tiltVariance;
  driftTilt(0.01, 1.0, robot.params, robot.state.modes);
  const double drift = robot.params.driftSd.rad();
  const double sway = robot.params.swaySd.rad();
  EXPECT_NEAR(robot.tilt().tiltVariance - known, 0.01 * (drift * drift + sway * sway), 1e-9);
}

TEST(Tilt, ALostRobotStillKnowsItsBody) {
  Watcher robot;
  robot.seeBeacon(0.0, 2.0, 10);
  lose(field2006(), {}, robot.state);
  EXPECT_NEAR(robot.tilt().tilt.deg(), 2.0, 0.1);
}

TEST(Tilt, GravityTellsALittleOfARobotAtRest) {
  Watcher robot;
  robot.input.stance.bodyTilt = Angle::deg(14);
  const double down = 12.0 * kDegree;  // so its nose is 2 deg higher than the stance says
  robot.input.sensors.acceleration = {-981.0 * std::sin(down), 0.0, 981.0 * std::cos(down)};
  for (int i = 0; i < 300; ++i) robot.look();
  EXPECT_GT(robot.tilt().tilt.deg(), 0.4);
  EXPECT_LT(robot.tilt().tilt.deg(), 1.5);
}

// What the pose has in common with the tilt: here 1 deg of tilt goes with 5 cm ahead.
TEST(Tilt, APoseThatWasWrongWithTheTiltIsCorrectedWithIt) {
  Watcher robot;
  robot.state.modes[0].cross = {5.0 / kDegree * robot.tilt().tiltVariance, 0, 0, 0, 0, 0};
  robot.state.modes[0].covariance[0] = 100.0;
  robot.seeBeacon(0.0, 1.0, 20);
  EXPECT_NEAR(robot.state.modes[0].pose.position.x - kPose.position.x, 5.0, 0.5);
}

// A level camera that sees the end of the carpet `degrees` lower than it is.
TEST(EdgeElevation, TellsTheTiltWhereThePoseIsKnown) {
  Watcher robot;
  PoseMode& mode = robot.state.modes[0];
  mode.pose = {{180.0, 200.0}, Angle::deg(90.0)};
  robot.camera.position = {0.0, 8.0, 20.0};
  robot.camera.axes = {1, 0, 0, 0, 0, 1, 0, -1, 0};
  const double away = body::carpetOf(field2006()).high.y - 208.0;
  const double row = 80.0 + 192.0 * std::tan(std::atan(20.0 / away) + 1.0 * kDegree);
  robot.percepts.fieldEdges.push_back({row, row, 20.0, 0.5});
  const GpsIn in{robot.input, robot.percepts, robot.camera};
  const TiltSightings seen = edgeSightings(in, field2006(), robot.params, mode);
  ASSERT_EQ(seen.size(), 2U);
  EXPECT_NEAR(seen[0].excess / kDegree, 1.0, 0.06);
  EXPECT_NEAR(seen[1].excess / kDegree, 1.0, 0.06);
  mode.covariance[0] = 3600.0;
  EXPECT_TRUE(edgeSightings(in, field2006(), robot.params, mode).empty());
}

// The line of one border runs on above the other, which nobody distinguished from it.
TEST(EdgeElevation, ALineAcrossACornerOfTheCarpetTellsNothing) {
  Watcher robot;
  PoseMode& mode = robot.state.modes[0];
  mode.pose = {{180.0, 270.0}, Angle::deg(55.0)};
  robot.camera.position = {0.0, 8.0, 20.0};
  robot.camera.axes = {1, 0, 0, 0, 0, 1, 0, -1, 0};
  robot.percepts.fieldEdges.push_back({92.0, 92.0, 20.0, 0.5});
  const GpsIn in{robot.input, robot.percepts, robot.camera};
  EXPECT_TRUE(edgeSightings(in, field2006(), robot.params, mode).empty());
}

// The points of a frame as they seem to lie when the camera is tilted and rolled more than thought.
SeenLines mislaid(const Pose2& pose, double tiltDeg, double rollDeg) {
  SeenLines seen = seenFrom(pose);
  const Point3<Robot> eye = seen.eye;
  for (SeenPoint& p : seen.lines) {
    const double x = p.place.x - eye.x;
    const double y = p.place.y - eye.y;
    const double t = -tiltDeg * kDegree;  // it is read as if it were not tilted
    const double r = -rollDeg * kDegree;
    const double down = eye.z - t * y + r * x;
    const double stretch = eye.z / down;
    p.place = {eye.x + (x - r * eye.z) * stretch, eye.y + (y + t * eye.z) * stretch};
    if (!(down > 0.1 * eye.z)) p.weight = 0.0;
  }
  return seen;
}

CameraTilt unsure(double sdDeg) {
  CameraTilt tilt;
  tilt.tiltVariance = tilt.rollVariance = std::pow(sdDeg * kDegree, 2);
  return tilt;
}

TEST(LineFitAndTilt, FindsPoseAndTiltWhereTheFixedTiltMisses) {
  const SeenLines seen = mislaid(kPose, 2.0, -1.0);
  const Pose2 start{{155.0, 115.0}, Angle::deg(42.0)};
  const LineFit fixed = fitLines(seen, start, features(), {}, true);
  const LineFit fit = fitLinesAndTilt(seen, start, unsure(1.5), features(), {}, true);
  EXPECT_GT(distance(fixed.pose.position, kPose.position), 5.0);
  EXPECT_LT(distance(fit.pose.position, kPose.position), 2.0);
  EXPECT_NEAR(fit.tilt.tilt.deg(), 2.0, 0.3);
  EXPECT_NEAR(fit.tilt.roll.deg(), -1.0, 0.3);
}

TEST(LineFitAndTilt, AFrameIsNoSurerThanItsTilt) {
  const SeenLines seen = seenFrom(kPose);
  double before = 1e9;
  for (const double sd : {0.05, 0.5, 3.0}) {
    const LineFit fit = fitLinesAndTilt(seen, kPose, unsure(sd), features(), {});
    EXPECT_LT(fit.information.determinant(), before);
    before = fit.information.determinant();
  }
}

TEST(LineFitAndTilt, WithAKnownTiltItIsTheFitOfThePose) {
  const SeenLines seen = seenFrom(kPose);
  const Pose2 start{{160.0, 110.0}, Angle::deg(47.0)};
  const LineFit fit = fitLinesAndTilt(seen, start, unsure(0.001), features(), {});
  const LineFit pose = fitLines(seen, start, features(), {});
  EXPECT_LT(distance(fit.pose.position, pose.pose.position), 0.05);
  EXPECT_LT((fit.information - pose.information).norm(), 0.01 * pose.information.norm());
}

// A whole state of five against the textbook: P' = P - P H' (H P H' + R)^-1 H P with H = I.
TEST(LineObservation, CorrectsTheStateOfFiveAsAKalmanFilterDoes) {
  PoseMode mode;
  mode.weight = 1.0;
  mode.pose = kPose;
  mode.tilt = unsure(1.0);
  Matrix5 root = Matrix5::Identity();
  for (int i = 0; i < 5; ++i)
    for (int j = 0; j < i; ++j) root(i, j) = 0.1 * (i + j);
  const Vector5 scale(4.0, 3.0, 0.05, 0.02, 0.02);
  const Matrix5 before = scale.asDiagonal() * root * root.transpose() * scale.asDiagonal();
  setState(mode, stateOf(mode), before);
  LineObservation seen;
  seen.pose.pose = {{kPose.position.x + 2.0, kPose.position.y - 1.0},
                    kPose.heading + Angle::deg(1.0)};
  seen.tilt = mode.tilt;
  seen.tilt.tilt = mode.tilt.tilt + Angle::deg(0.5);
  const Matrix5 r = scale.cwiseProduct(scale).asDiagonal();
  seen.information = r.inverse();
  seen.tiltPull = Vector2::Zero();
  Vector5 off;
  off << 2.0, -1.0, 1.0 * kDegree, 0.5 * kDegree, 0.0;
  const Matrix5 gain = before * (before + r).inverse();
  const PoseMode after = corrected(mode, seen);
  EXPECT_LT((stateOf(after) - stateOf(mode) - gain * off).norm(), 1e-9);
  EXPECT_LT((stateCovarianceOf(after) - (before - gain * before)).norm(), 1e-9);
  EXPECT_NEAR(after.weight, std::exp(-0.5 * off.dot((before + r).inverse() * off)), 1e-9);
}

}  // namespace
}  // namespace kelpie::gps
