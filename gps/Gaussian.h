// SPDX-License-Identifier: Apache-2.0
// The stored mode (plain arrays) seen as Eigen vectors and matrices. State (x, y, heading).
#pragma once

#include <Eigen/Dense>

#include "robot/core/WorldModel.h"

namespace kelpie::gps {

using Vector2 = Eigen::Matrix<double, 2, 1>;
using Vector3 = Eigen::Matrix<double, 3, 1>;
using Matrix2 = Eigen::Matrix<double, 2, 2>;
using Matrix3 = Eigen::Matrix<double, 3, 3>;

inline Vector3 meanOf(const PoseMode& mode) {
  return {mode.pose.position.x, mode.pose.position.y, mode.pose.heading.rad()};
}

inline Pose2 poseOf(const Vector3& mean) { return {{mean(0), mean(1)}, Angle::rad(mean(2))}; }

inline Matrix3 covarianceOf(const PoseMode& mode) {
  return Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(mode.covariance.data());
}

// Stores the symmetric part: rounding must not let the halves drift apart.
inline void setCovariance(PoseMode& mode, const Matrix3& covariance) {
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) {
      mode.covariance[static_cast<std::size_t>(3 * row + column)] =
          0.5 * (covariance(row, column) + covariance(column, row));
    }
  }
}

// An information or covariance of a pose when the field is turned.
inline Matrix3 turned(const Matrix3& matrix, Angle by) {
  Matrix3 turn = Matrix3::Identity();
  turn(0, 0) = turn(1, 1) = by.cos();
  turn(0, 1) = -by.sin();
  turn(1, 0) = by.sin();
  return turn * matrix * turn.transpose();
}

}  // namespace kelpie::gps
