// SPDX-License-Identifier: Apache-2.0
#include "gps/ball/BallMotion.h"

#include <algorithm>

#include "gps/ball/BallGaussian.h"

namespace kelpie::gps {
namespace {

Matrix2 rotation(double angle) {
  const double s = maths::sin(angle);
  const double c = maths::cos(angle);
  Matrix2 m;
  m << c, -s, s, c;
  return m;
}

}  // namespace

Point2<Robot> seenAfter(Point2<Robot> point, const Odometry& odometry) {
  const double turn = odometry.turn.rad();
  const Vector2 step = rotation(0.5 * turn) * Vector2(-odometry.left, odometry.forward);
  const Vector2 seen = rotation(-turn) * (Vector2(point.x, point.y) - step);
  return {seen(0), seen(1)};
}

void moveRobot(BallHypothesis& ball, const Odometry& odometry, const StepNoise& noise) {
  BallVector mean = meanOf(ball);
  const Point2<Robot> position = seenAfter({mean(0), mean(1)}, odometry);
  const Matrix2 turned = rotation(-odometry.turn.rad());
  BallMatrix f = BallMatrix::Zero();
  f.topLeftCorner<2, 2>() = turned;
  f.bottomRightCorner<2, 2>() = turned;
  mean.tail<2>() = turned * Vector2(mean(2), mean(3));
  mean.head<2>() << position.x, position.y;
  BallMatrix covariance = f * covarianceOf(ball) * f.transpose();
  covariance(0, 0) += noise.left;
  covariance(1, 1) += noise.forward;
  const Vector2 swing(-position.y, position.x);  // where an error of the turn moves the ball
  covariance.topLeftCorner<2, 2>() += noise.turn * swing * swing.transpose();
  set(ball, mean, covariance);
}

void roll(BallHypothesis& ball, double elapsed, const BallFilterParams& params) {
  BallVector mean = meanOf(ball);
  const double speed = maths::hypot(mean(2), mean(3));
  const double slower = (params.deceleration + params.drag * speed) * elapsed;
  const double factor = speed > slower ? (speed - slower) / speed : 0.0;
  BallMatrix f = BallMatrix::Identity();
  f(0, 2) = f(1, 3) = 0.5 * (1.0 + factor) * elapsed;
  f(2, 2) = f(3, 3) = std::max(0.0, 1.0 - params.drag * elapsed);
  mean.head<2>() += f(0, 2) * mean.tail<2>();
  mean.tail<2>() *= factor;
  BallMatrix covariance = f * covarianceOf(ball) * f.transpose();
  for (int i = 0; i < 2; ++i) covariance(i, i) += params.positionNoise * elapsed;
  set(ball, mean, covariance);
}

double rollingDistance(double speed, const BallFilterParams& params) {
  const double k = params.drag;
  const double c = params.deceleration;
  if (k < 1e-6) return c > 0.0 ? 0.5 * speed * speed / c : 0.0;
  if (c < 1e-6) return speed / k;
  return speed / k - c / (k * k) * maths::log(1.0 + k * speed / c);
}

}  // namespace kelpie::gps
