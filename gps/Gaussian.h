// SPDX-License-Identifier: Apache-2.0
// The stored mode (plain arrays) seen as Eigen vectors and matrices: the pose (x, y, heading), and
// the whole state (x, y, heading, tilt, roll).
#pragma once

#include <Eigen/Dense>

#include "robot/core/types/WorldModel.h"

namespace kelpie::gps {

using Vector2 = Eigen::Matrix<double, 2, 1>;
using Vector3 = Eigen::Matrix<double, 3, 1>;
using Matrix2 = Eigen::Matrix<double, 2, 2>;
using Matrix3 = Eigen::Matrix<double, 3, 3>;
using Vector5 = Eigen::Matrix<double, 5, 1>;
using Matrix5 = Eigen::Matrix<double, 5, 5>;
using Matrix32 = Eigen::Matrix<double, 3, 2>;

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

inline Vector2 tiltMeanOf(const CameraTilt& tilt) { return {tilt.tilt.rad(), tilt.roll.rad()}; }

inline Matrix2 tiltCovarianceOf(const CameraTilt& tilt) {
  Matrix2 matrix;
  matrix << tilt.tiltVariance, tilt.covariance, tilt.covariance, tilt.rollVariance;
  return matrix;
}

inline void setTilt(CameraTilt& tilt, const Vector2& mean, const Matrix2& covariance) {
  tilt = {Angle::rad(mean(0)), Angle::rad(mean(1)), covariance(0, 0), covariance(1, 1),
          0.5 * (covariance(0, 1) + covariance(1, 0))};
}

// Covariance of the pose (rows) with tilt and roll.
inline Matrix32 crossOf(const PoseMode& mode) {
  return Eigen::Map<const Eigen::Matrix<double, 3, 2, Eigen::RowMajor>>(mode.cross.data());
}

inline void setCross(PoseMode& mode, const Matrix32& cross) {
  Eigen::Map<Eigen::Matrix<double, 3, 2, Eigen::RowMajor>>(mode.cross.data()) = cross;
}

inline Vector5 stateOf(const PoseMode& mode) {
  Vector5 state;
  state << meanOf(mode), tiltMeanOf(mode.tilt);
  return state;
}

inline Matrix5 stateCovarianceOf(const PoseMode& mode) {
  const Matrix32 cross = crossOf(mode);
  Matrix5 covariance;
  covariance << covarianceOf(mode), cross, cross.transpose(), tiltCovarianceOf(mode.tilt);
  return covariance;
}

inline void setState(PoseMode& mode, const Vector5& mean, const Matrix5& covariance) {
  mode.pose = poseOf(mean.head<3>());
  setCovariance(mode, covariance.topLeftCorner<3, 3>());
  setCross(mode, covariance.topRightCorner<3, 2>());
  setTilt(mode.tilt, mean.tail<2>(), covariance.bottomRightCorner<2, 2>());
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
