// SPDX-License-Identifier: Apache-2.0
#include "gps/pose/Predict.h"

#include <algorithm>
#include <cmath>

#include "gps/Gaussian.h"

namespace kelpie::gps {
namespace {

constexpr double kMaxStep = 30.0;  // cm; 42 cm/s at 30 Hz is 1.4, a dropped second is 42

// The step is an arc; half of the turn comes before the middle of it.
Angle directionOfStep(const Pose2& pose, const Odometry& odometry) {
  return Angle::rad(pose.heading.rad() + 0.5 * odometry.turn.rad());
}

// Estimated at all, and what one frame of walking or kicking can be wrong by.
bool likely(const OdometryVariance& reported) {
  constexpr double kMaxSquare = 100.0;  // cm2
  constexpr double kMaxTurn = 0.1;      // rad2
  const auto within = [](double value, double max) { return value >= 0.0 && value <= max; };
  return within(reported.forward, kMaxSquare) && within(reported.left, kMaxSquare) &&
         within(reported.turn, kMaxTurn) && reported.forward + reported.left + reported.turn > 0.0;
}

}  // namespace

double elapsedOf(const FrameInput& input) {
  constexpr double kMaxElapsed = 10.0;  // s; after a longer gap the robot is lost in any case
  return input.elapsed > 0.0 ? std::min(input.elapsed, kMaxElapsed) : 0.0;
}

bool plausible(const Odometry& odometry) {
  return std::isfinite(odometry.forward) && std::isfinite(odometry.left) &&
         std::fabs(odometry.turn.rad()) <= maths::kPi && std::fabs(odometry.forward) <= kMaxStep &&
         std::fabs(odometry.left) <= kMaxStep;
}

StepNoise stepNoise(const Odometry& odometry, double elapsed, const MotionNoise& noise) {
  const OdometryVariance& reported = odometry.variance;
  if (likely(reported)) {
    const double pushes = noise.positionPerSecond * elapsed;
    return {reported.forward + pushes, reported.left + pushes,
            reported.turn + noise.turnPerSecond * elapsed};
  }
  const double forward = std::fabs(odometry.forward);
  const double left = std::fabs(odometry.left);
  const double turn = std::fabs(odometry.turn.rad());
  const double always = noise.positionPerSecond * elapsed + noise.positionPerRad * turn;
  StepNoise step;
  step.forward = noise.alongPerCm * forward + noise.acrossPerCm * left + always;
  step.left = noise.alongPerCm * left + noise.acrossPerCm * forward + always;
  step.turn =
      noise.turnPerRad * turn + noise.turnPerCm * (forward + left) + noise.turnPerSecond * elapsed;
  return step;
}

StepNoise scaledBy(double scale, const StepNoise& noise) {
  return {scale * noise.forward, scale * noise.left, scale * noise.turn};
}

Pose2 moved(const Pose2& pose, const Odometry& odometry) {
  const Pose2 middle{pose.position, directionOfStep(pose, odometry)};
  return {fieldFromRobot(middle, {-odometry.left, odometry.forward}), pose.heading + odometry.turn};
}

std::array<double, 9> movedJacobian(const Pose2& pose, const Odometry& odometry) {
  const Point2<Field> step = moved(pose, odometry).position - pose.position;
  return {1, 0, -step.y, 0, 1, step.x, 0, 0, 1};
}

void predict(PoseMode& mode, const Odometry& odometry, const StepNoise& noise) {
  const Angle direction = directionOfStep(mode.pose, odometry);
  const double s = direction.sin();
  const double c = direction.cos();
  const auto jacobian = movedJacobian(mode.pose, odometry);
  const Matrix3 f = Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(jacobian.data());
  Matrix3 turned;  // columns: forward, left and turn of the robot in the field
  turned << c, -s, 0, s, c, 0, 0, 0, 1;
  const Vector3 variances(noise.forward, noise.left, noise.turn);
  const Matrix3 q = turned * variances.asDiagonal() * turned.transpose();
  setCovariance(mode, f * covarianceOf(mode) * f.transpose() + q);
  setCross(mode, f * crossOf(mode));
  mode.pose = moved(mode.pose, odometry);
}

}  // namespace kelpie::gps
