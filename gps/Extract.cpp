// SPDX-License-Identifier: Apache-2.0
#include "gps/Extract.h"

#include <algorithm>
#include <cmath>

#include "gps/OnField.h"
#include "gps/SamePose.h"
#include "gps/ball/BallMotion.h"
#include "robot/core/fields/Emptied.h"

namespace kelpie::gps {
namespace {

double sdOf(double variance) { return std::sqrt(std::max(0.0, variance)); }

// Root of the larger eigenvalue of the position's 2 x 2 block.
double positionSd(const std::array<double, 9>& c) {
  const double mean = 0.5 * (c[0] + c[4]);
  const double half = 0.5 * (c[0] - c[4]);
  return sdOf(mean + std::sqrt(half * half + c[1] * c[1]));
}

// What is believed of the error of the heaviest mode's place, the other modes' included: while one
// landmark is all that was seen, each of them is narrow, and one is right.
std::array<double, 9> covarianceAboutBest(const Modes& modes) {
  std::array<double, 9> sum{};
  double total = 0.0;
  for (const PoseMode& mode : modes) total += mode.weight;
  if (!(total > 0.0)) return modes[0].covariance;
  for (const PoseMode& mode : modes) {
    const Point2<Field> off = mode.pose.position - modes[0].pose.position;
    const std::array<double, 3> apart{off.x, off.y,
                                      (mode.pose.heading - modes[0].pose.heading).rad()};
    for (std::size_t i = 0; i < sum.size(); ++i)
      sum[i] += mode.weight / total * (mode.covariance[i] + apart[i / 3] * apart[i % 3]);
  }
  return sum;
}

// Which of the places from which one landmark looks like this was taken for the right one may be
// wrong, and no mode is left to tell: 64 of 90,000 frames were more than a metre off at an sd below
// 15 cm. Until another is seen the sd is no less.
void doubtOneLandmark(std::uint8_t kindsSeen, std::array<double, 9>& covariance) {
  constexpr double kLeastSd = 15.0;  // cm
  const bool one = kindsSeen != 0 && (kindsSeen & (kindsSeen - 1U)) == 0;
  if (!one) return;
  covariance[0] += maths::square(kLeastSd);
  covariance[4] += maths::square(kLeastSd);
}

OdometryErrorEstimate odometryErrorsOf(const OdometryErrors& errors) {
  const auto& mean = errors.mean;
  const auto& c = errors.covariance;
  if (!(c[0] + c[4] + c[8] > 0.0)) return {};
  return {true, mean[0], sdOf(c[0]), mean[1], sdOf(c[4]), mean[2], sdOf(c[8])};
}

// Nearer than `moved` cm to its place each of them stands somewhere: maps, hands and the filter
// itself are no more exact.
void tellMoved(const LandmarkOffsets& offsets, double moved, MovedLandmarks& told) {
  for (std::size_t i = 0; i < kLandmarkKindCount; ++i) {
    const Point2<Field> offset{offsets.landmarks[i].x, offsets.landmarks[i].y};
    if (offset.norm() > moved) told.push_back({static_cast<LandmarkKind>(i), offset});
  }
}

// Where the ball will lie: each model's end, weighed.
Point2<Robot> stoppingPointOf(const BallTrack& ball, const BallFilterParams& params) {
  const std::array<double, 4>& rolling = ball.rolling.mean;
  const double speed = maths::hypot(rolling[2], rolling[3]);
  const double way = speed > 0.0 ? rollingDistance(speed, params) / speed : 0.0;
  const double share = ball.rolling.weight;
  return {ball.both.mean[0] + share * way * rolling[2],
          ball.both.mean[1] + share * way * rolling[3]};
}

BallEstimate extractBall(const BallTrack& track, const PoseMode& mode,
                         const BallFilterParams& params) {
  const Pose2& pose = mode.pose;
  BallEstimate ball;
  ball.present = track.present;
  ball.secondsSinceSeen = track.secondsSinceSeen;
  if (!track.present) return ball;
  const std::array<double, 4>& mean = track.both.mean;
  const std::array<double, 16>& covariance = track.both.covariance;
  ball.relative = {mean[0], mean[1]};
  ball.distance = ball.relative.norm();
  ball.heading = bearing(ball.relative);
  ball.covariance = {covariance[0], covariance[1], covariance[4], covariance[5]};
  ball.position = fieldFromRobot(pose, ball.relative);
  const Pose2 turnOnly{{}, pose.heading};
  ball.velocity = fieldFromRobot(turnOnly, {mean[2], mean[3]});
  ball.fieldCovariance =
      rowsOf(placeOnField(mode, ball.relative, matrixOf(ball.covariance)).covariance);
  ball.stoppingPoint = fieldFromRobot(pose, stoppingPointOf(track, params));
  return ball;
}

// Copies that a merge left apart say nothing new; a robot's length does, or a turn that misses the
// goal.
constexpr double kElsewhereCm = 30.0;
constexpr double kElsewhereDeg = 20.0;

SecondHypothesis secondOf(const Modes& modes) {
  for (const PoseMode& mode : modes)
    if (!samePose(mode.pose, modes[0].pose, kElsewhereCm, kElsewhereDeg)) return {true, mode};
  return {};
}

}  // namespace

void extractInto(WorldModel& world, const GpsState& state, const GpsParams& params) {
  makeEmpty(world);
  for (const PoseMode& mode : state.pose.modes) world.modes.push_back(mode);
  world.pose = state.pose.modes[0].pose;
  world.covariance = covarianceAboutBest(state.pose.modes);
  doubtOneLandmark(state.pose.kindsSeen, world.covariance);
  world.positionSd = positionSd(world.covariance);
  world.headingSd = Angle::rad(std::min(sdOf(world.covariance[8]), maths::kPi));
  world.cameraTilt = state.pose.modes[0].tilt;
  world.focalScale = state.pose.focal;
  world.imageLag = state.pose.lag;
  world.odometryErrors = odometryErrorsOf(state.pose.odometry);
  tellMoved(state.pose.offsets, params.landmarkOffsets.moved, world.movedLandmarks);
  world.secondsSinceLandmark = state.pose.secondsSinceLandmark;
  world.secondsSinceLines = state.pose.secondsSinceLines;
  world.second = secondOf(state.pose.modes);
  world.stuck = state.pose.stuck.share;
  world.ball = extractBall(state.ball.track, state.pose.modes[0], params.ball);
  copyUsed(world.pinkMap, state.pinks.map);
}

WorldModel extract(const GpsState& state, const GpsParams& params) {
  WorldModel world;
  extractInto(world, state, params);
  return world;
}

}  // namespace kelpie::gps
