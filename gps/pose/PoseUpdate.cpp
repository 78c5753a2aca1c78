// SPDX-License-Identifier: Apache-2.0
#include "gps/pose/PoseUpdate.h"

#include <algorithm>
#include <cmath>

namespace kelpie::gps {
namespace {

constexpr double kMinDistance = 5.0;         // cm, a beacon's radius: nearer is not linear
constexpr double kDegenerateWeight = 1e-20;  // weight factor where nothing can be computed
// Mean weight factor of the true mode by distance and heading: E exp(-0.5 chi squared) of two.
constexpr double kMeanFactor = 0.5;

Vector3 difference(const Pose2& to, const Pose2& from) {
  const Point2<Field> d = to.position - from.position;
  return {d.x, d.y, (to.heading - from.heading).rad()};
}

// What an observation of the pose says of the tilt: x += C' (y - Y shift), C := S C and
// T -= C' Y S C, the joint filter's update without an inverse of P.
void carryTilt(const InformationSum& information, const Matrix3& shrink, const Vector3& shift,
               PoseMode& mode) {
  const Matrix32 cross = crossOf(mode);
  const Matrix32 after = shrink * cross;
  const Vector2 pull = cross.transpose() * (information.vector - information.matrix * shift);
  const Matrix2 less = cross.transpose() * information.matrix * after;
  setTilt(mode.tilt, tiltMeanOf(mode.tilt) + pull, tiltCovarianceOf(mode.tilt) - less);
  setCross(mode, after);
}

// Of the innovation's density: sqrt(det R / det S) = 1 / sqrt(det(1 + P Y)).
double vaguenessFactor(const PoseMode& mode, const InformationSum& information) {
  if (information.degenerate) return 1.0;
  const Matrix3 sum = Matrix3::Identity() + covarianceOf(mode) * information.matrix;
  return 1.0 / std::sqrt(std::max(1.0, sum.determinant()));
}

}  // namespace

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

Innovation bearingInnovation(const PoseMode& mode, const Measurement& seen) {
  const Expectation e = expected(mode.pose, seen.landmark);
  const Vector3 h(e.jacobian[3], e.jacobian[4], e.jacobian[5]);
  return {(seen.heading - e.heading).rad(), h.dot(covarianceOf(mode) * h) + seen.headingVariance};
}

void InformationSum::add(const PoseMode& mode, const Measurement& m, const Pose2& at) {
  if (distance(m.landmark, at.position) < kMinDistance) {
    degenerate = true;
    return;
  }
  const Expectation e = expected(at, m.landmark);
  const Vector3 offset = difference(at, mode.pose);
  const double innovation[2] = {m.distance - e.distance, (m.heading - e.heading).rad()};
  const double variance[2] = {m.distanceVariance, m.headingVariance};
  const bool use[2] = {m.useDistance, m.useHeading};
  for (std::size_t row = 0; row < 2; ++row) {
    if (!use[row]) continue;
    const double* j = e.jacobian.data() + 3 * row;
    const Vector3 h(j[0], j[1], j[2]);
    const double fromMode = innovation[row] + h.dot(offset);
    matrix += h * h.transpose() / variance[row];
    vector += h * (fromMode / variance[row]);
    chiSquared += fromMode * fromMode / variance[row];
  }
}

void InformationSum::add(const PoseMode& mode, const PoseObservation& observation) {
  const Vector3 innovation = difference(observation.pose, mode.pose);
  const Vector3 pull = observation.information * innovation;
  matrix += observation.information;
  vector += pull;
  chiSquared += innovation.dot(pull);
}

PoseMode corrected(const PoseMode& mode, const InformationSum& information) {
  PoseMode result = mode;
  if (information.degenerate) {
    result.weight *= kDegenerateWeight;
    return result;
  }
  const Matrix3 p = covarianceOf(mode);
  const Matrix3 sum = Matrix3::Identity() + p * information.matrix;
  const Matrix3 shrink = sum.inverse();
  const Matrix3 after = shrink * p;
  const Vector3 shift = after * information.vector;
  // nu' E^-1 nu = nu' R^-1 nu - y' P' y, by the matrix inversion lemma.
  const double squaredInnovation =
      std::max(0.0, information.chiSquared - information.vector.dot(shift));
  result.weight *= maths::exp(-0.5 * squaredInnovation);
  result.pose = poseOf(meanOf(mode) + shift);
  setCovariance(result, after);
  carryTilt(information, shrink, shift, result);
  return result;
}

PoseMode corrected(const PoseMode& mode, const Measurement& measurement) {
  InformationSum information;
  information.add(mode, measurement, mode.pose);
  return corrected(mode, information);
}

PoseMode correctedByLandmark(const PoseMode& mode, const Measurement& seen) {
  InformationSum whole;
  whole.add(mode, seen, mode.pose);
  const bool grazing = atGrazingAngle(mode, seen);
  PoseMode result = grazing ? corrected(mode, headingOnly(seen)) : corrected(mode, whole);
  result.weight *= vaguenessFactor(mode, whole) * (grazing ? kMeanFactor : 1.0);
  return result;
}

PoseMode corrected(const PoseMode& mode, const PoseObservation& observation) {
  InformationSum information;
  information.add(mode, observation);
  return corrected(mode, information);
}

}  // namespace kelpie::gps
