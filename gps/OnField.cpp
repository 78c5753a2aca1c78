// SPDX-License-Identifier: Apache-2.0
#include "gps/OnField.h"

#include <cmath>

namespace kelpie::gps {

PlaceFromPose placeFrom(const Pose2& pose, Point2<Robot> point, const Matrix2& covariance) {
  const double s = pose.heading.sin();
  const double c = pose.heading.cos();
  Matrix2 turned;
  turned << s, c, -c, s;
  Eigen::Matrix<double, 2, 3> jacobian;
  jacobian << 1.0, 0.0, c * point.x - s * point.y, 0.0, 1.0, s * point.x + c * point.y;
  return {{vectorOf(fieldFromRobot(pose, point)), turned * covariance * turned.transpose()},
          jacobian};
}

Place placeOnField(const PoseMode& pose, Point2<Robot> point, const Matrix2& covariance) {
  PlaceFromPose placed = placeFrom(pose.pose, point, covariance);
  placed.place.covariance += placed.jacobian * covarianceOf(pose) * placed.jacobian.transpose();
  return placed.place;
}

Matrix2 matrixOf(const std::array<double, 4>& rows) {
  const double cross = 0.5 * (rows[1] + rows[2]);
  Matrix2 matrix;
  matrix << rows[0], cross, cross, rows[3];
  return matrix;
}

std::array<double, 4> rowsOf(const Matrix2& matrix) {
  const double cross = 0.5 * (matrix(0, 1) + matrix(1, 0));
  return {matrix(0, 0), cross, cross, matrix(1, 1)};
}

Place productOf(const Place& a, const Place& b) {
  const Matrix2 gain = a.covariance * (a.covariance + b.covariance).inverse();
  const Matrix2 keep = Matrix2::Identity() - gain;
  return {a.mean + gain * (b.mean - a.mean),
          keep * a.covariance * keep.transpose() + gain * b.covariance * gain.transpose()};
}

double mahalanobisSquared(const Place& a, const Place& b) {
  const Vector2 d = a.mean - b.mean;
  return d.dot((a.covariance + b.covariance).inverse() * d);
}

bool soundCovariance(const std::array<double, 4>& rows, double min, double max) {
  for (const double value : rows) {
    if (!std::isfinite(value)) return false;
  }
  const Matrix2 m = matrixOf(rows);
  const bool inRange = m(0, 0) >= min && m(1, 1) >= min && m(0, 0) <= max && m(1, 1) <= max;
  return inRange && m(0, 0) * m(1, 1) - m(0, 1) * m(0, 1) > 1e-6 * m(0, 0) * m(1, 1);
}

}  // namespace kelpie::gps
