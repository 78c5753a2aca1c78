// SPDX-License-Identifier: Apache-2.0
#include "gps/pose/Update.h"

#include <cmath>

#include "gps/Gaussian.h"

namespace kelpie::gps {
namespace {

template <int N>
struct Linear {
  Eigen::Matrix<double, N, 1> innovation;
  Eigen::Matrix<double, N, 3> jacobian;
  Eigen::Matrix<double, N, 1> variance;
};

template <int N>
void correct(PoseMode& mode, const Linear<N>& z, bool weighByDeterminant) {
  using Square = Eigen::Matrix<double, N, N>;
  const Matrix3 p = covarianceOf(mode);
  const Square r = z.variance.asDiagonal();
  const Square e = r + z.jacobian * p * z.jacobian.transpose();
  const Square inverse = e.inverse();
  const Eigen::Matrix<double, 3, N> gain = p * z.jacobian.transpose() * inverse;
  const Matrix3 keep = Matrix3::Identity() - gain * z.jacobian;
  const double squaredInnovation = z.innovation.dot(inverse * z.innovation);
  mode.weight *= maths::exp(-0.5 * squaredInnovation);
  if (weighByDeterminant) mode.weight *= std::sqrt(r.determinant() / e.determinant());
  mode.pose = poseOf(meanOf(mode) + gain * z.innovation);
  // Joseph's form: stays positive where (1 - K H) P would not.
  setCovariance(mode, keep * p * keep.transpose() + gain * r * gain.transpose());
}

Linear<2> linearised(const Measurement& m, const Expectation& e) {
  Linear<2> z;
  z.innovation << m.distance - e.distance, (m.heading - e.heading).rad();
  z.jacobian = Eigen::Map<const Eigen::Matrix<double, 2, 3, Eigen::RowMajor>>(e.jacobian.data());
  z.variance << m.distanceVariance, m.headingVariance;
  return z;
}

Linear<1> only(const Linear<2>& both, int row) {
  Linear<1> z;
  z.innovation = both.innovation.segment<1>(row);
  z.jacobian = both.jacobian.row(row);
  z.variance = both.variance.segment<1>(row);
  return z;
}

}  // namespace

bool tooCloseToLinearise(const Pose2& pose, Point2<Field> landmark) {
  constexpr double kMinDistance = 5.0;  // cm, a beacon's radius
  return distance(landmark, pose.position) < kMinDistance;
}

Expectation expected(const Pose2& pose, Point2<Field> landmark) {
  const Point2<Field> d = landmark - pose.position;
  const double r = d.norm();
  const double r2 = r * r;
  Expectation e;
  e.distance = r;
  e.heading = Angle::rad(maths::atan2(d.y, d.x)) - pose.heading;
  e.jacobian = {-d.x / r, -d.y / r, 0.0, d.y / r2, -d.x / r2, -1.0};
  return e;
}

void update(PoseMode& mode, const Measurement& measurement, bool weighByDeterminant) {
  if (tooCloseToLinearise(mode.pose, measurement.landmark)) {
    mode.weight *= kDegenerateWeight;
    return;
  }
  const Linear<2> z = linearised(measurement, expected(mode.pose, measurement.landmark));
  if (measurement.useDistance && measurement.useHeading)
    return correct(mode, z, weighByDeterminant);
  correct(mode, only(z, measurement.useDistance ? 0 : 1), weighByDeterminant);
}

}  // namespace kelpie::gps
