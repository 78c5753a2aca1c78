// SPDX-License-Identifier: Apache-2.0
#include "gps/pose/OdometryErrors.h"

#include <algorithm>
#include <cmath>

#include "gps/Gaussian.h"

namespace kelpie::gps {
namespace {

using RowMajor3 = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;

Matrix3 matrixOf(const std::array<double, 9>& rows) {
  return Eigen::Map<const RowMajor3>(rows.data());
}

void set(std::array<double, 9>& rows, const Matrix3& matrix) {
  Eigen::Map<RowMajor3>(rows.data()) = matrix;
}

bool walks(const Odometry& told) {
  return told.forward != 0.0 || told.left != 0.0 || told.turn.rad() != 0.0;
}

// How the pose moves with scale ahead, scale aside and turn.
Matrix3 slopeOf(const Pose2& pose, const Odometry& told, double elapsed) {
  const double c = pose.heading.cos();
  const double s = pose.heading.sin();
  Matrix3 slope;
  slope << c * told.forward, -s * told.left, 0, s * told.forward, c * told.left, 0, 0, 0,
      walks(told) ? elapsed : 0.0;
  return slope;
}

// However long the carpet has had to change.
void drift(double elapsed, const OdometryErrorsParams& params, OdometryErrors& errors) {
  const auto grow = [elapsed](double by, double max, double& variance) {
    variance = std::max(variance, std::min(variance + elapsed * by * by, max * max));
  };
  grow(params.scaleDrift, params.scaleSd, errors.covariance[0]);
  grow(params.scaleDrift, params.scaleSd, errors.covariance[4]);
  grow(params.turnDrift, params.turnSd, errors.covariance[8]);
}

Matrix3 moveJacobian(const Pose2& pose, const Odometry& step) {
  return matrixOf(movedJacobian(pose, step));
}

}  // namespace

OdometryErrors startingErrors(const OdometryErrorsParams& params) {
  OdometryErrors errors;
  if (!params.use) return errors;
  const double scale = maths::square(params.scaleSd);
  errors.covariance = {scale, 0, 0, 0, scale, 0, 0, 0, maths::square(params.turnSd)};
  return errors;
}

Odometry corrected(const Odometry& told, double elapsed, const OdometryErrors& errors) {
  if (!walks(told)) return told;
  return {(1.0 + errors.mean[0]) * told.forward, (1.0 + errors.mean[1]) * told.left,
          told.turn + Angle::rad(errors.mean[2] * elapsed), told.variance};
}

void predictAll(const Odometry& told, const Step& step, double elapsed,
                const OdometryErrorsParams& params, PoseState& state) {
  OdometryErrors& errors = state.odometry;
  const Matrix3 doubt = matrixOf(errors.covariance);
  const Matrix3 cross = matrixOf(errors.cross);
  for (std::size_t i = 0; i < state.modes.size(); ++i) {
    PoseMode& mode = state.modes[i];
    const Matrix3 f = moveJacobian(mode.pose, step.odometry);
    const Matrix3 slope = slopeOf(mode.pose, told, elapsed);
    predict(mode, step.odometry, step.noise);
    if (!params.use) continue;
    const Matrix3 grown = slope * doubt;
    if (i > 0) {
      setCovariance(mode, covarianceOf(mode) + params.othersFrames * grown * slope.transpose());
      continue;
    }
    const Matrix3 both = f * cross * slope.transpose();
    setCovariance(mode, covarianceOf(mode) + both + both.transpose() + grown * slope.transpose());
    set(errors.cross, f * cross + grown);
  }
  if (!params.use) return;
  drift(elapsed, params, errors);
  errors.predicted = state.modes.empty() ? PoseMode{} : state.modes[0];
}

void learnErrors(const OdometryErrorsParams& params, PoseState& state) {
  OdometryErrors& errors = state.odometry;
  if (!params.use || state.modes.empty()) return;
  const PoseMode& now = state.modes[0];
  const PoseMode& then = errors.predicted;
  if (now.covariance == then.covariance) return;
  Vector3 shift = meanOf(now) - meanOf(then);
  shift(2) = (now.pose.heading - then.pose.heading).rad();
  const Matrix3 before = covarianceOf(then);
  const Matrix3 inverse = before.inverse();
  const bool same = !state.lost && shift.dot(inverse * shift) <= maths::square(params.gate);
  const Matrix3 cross = matrixOf(errors.cross);
  const Matrix3 gain = cross.transpose() * inverse;
  const Matrix3 after = covarianceOf(now);
  const Vector3 learnt = gain * shift;
  const Matrix3 left = matrixOf(errors.covariance) + gain * (after - before) * gain.transpose();
  const bool sound = learnt.allFinite() && left.allFinite() && left.diagonal().minCoeff() > 0.0;
  if (!same || !sound) {
    errors.cross = {};
    return;
  }
  set(errors.cross, after * gain.transpose());
  // Lines alone fit a wrong pose as well, and what it taught would carry the robot on there.
  if (state.secondsSinceLandmark > 0.0) return;
  const std::array<double, 3> max{params.max, params.max, params.maxTurn};
  for (int k = 0; k < 3; ++k) {
    double& mean = errors.mean[static_cast<std::size_t>(k)];
    const double limit = max[static_cast<std::size_t>(k)];
    mean = maths::clamp(mean + learnt(k), -limit, limit);
  }
  set(errors.covariance, 0.5 * (left + left.transpose()));
}

}  // namespace kelpie::gps
