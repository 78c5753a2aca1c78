// SPDX-License-Identifier: Apache-2.0
// A stored hypothesis of the ball seen as Eigen vectors and matrices. State (x right, y forward,
// vx, vy).
#pragma once

#include "gps/Gaussian.h"
#include "gps/ball/BallState.h"

namespace kelpie::gps {

using BallVector = Eigen::Matrix<double, 4, 1>;
using BallMatrix = Eigen::Matrix<double, 4, 4>;

inline BallVector meanOf(const BallHypothesis& ball) {
  return Eigen::Map<const BallVector>(ball.mean.data());
}

inline BallMatrix covarianceOf(const BallHypothesis& ball) {
  return Eigen::Map<const BallMatrix>(ball.covariance.data());  // symmetric: order is no matter
}

inline void set(BallHypothesis& ball, const BallVector& mean, const BallMatrix& covariance) {
  Eigen::Map<BallVector>(ball.mean.data()) = mean;
  Eigen::Map<BallMatrix>(ball.covariance.data()) = 0.5 * (covariance + covariance.transpose());
}

}  // namespace kelpie::gps
