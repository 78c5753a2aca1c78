// SPDX-License-Identifier: Apache-2.0
#include "gps/camera/Focal.h"

#include <cmath>

#include "gps/Gaussian.h"
#include "gps/camera/ScalarFilter.h"
#include "gps/pose/PoseUpdate.h"

namespace kelpie::gps {
namespace {

constexpr double kKnownSd = 1e-4;  // where it is not estimated

void update(const ScalarSighting& z, const FocalParams& params, FocalScale& focal) {
  correct(z, {1.0 - params.max, 1.0 + params.max, params.minSd, params.gate}, focal.ratio,
          focal.variance);
}

// Beside the camera's axis, positive to the left.
double besideAxis(const CameraPose& camera, Angle heading) {
  return (heading - Angle::rad(maths::atan2(-camera.axes[2], camera.axes[5]))).rad();
}

}  // namespace

FocalScale startingFocal(const FocalParams& params) {
  return {1.0, maths::square(params.use ? params.initialSd : kKnownSd)};
}

void updateFocal(const GpsIn& in, const PoseMode& mode, const Measurement& seen,
                 const FocalParams& params, FocalScale& focal) {
  if (!params.use || mode.covariance[8] > maths::square(params.maxHeadingSd.rad())) return;
  const double learned = focal.ratio - in.input.focalScale.ratio;
  if (seen.useHeading) {
    const double slope = besideAxis(in.camera, seen.heading);
    const Innovation bearing = bearingInnovation(mode, seen);
    update({bearing.value - slope * learned, slope, bearing.variance}, params, focal);
  }
  if (seen.useDistance) {
    const Expectation e = expected(mode.pose, seen.landmark);
    const Vector3 h(e.jacobian[0], e.jacobian[1], e.jacobian[2]);
    const double slope = -e.distance;
    const double spread = seen.distanceVariance + maths::square(params.distanceSd * e.distance);
    update({seen.distance - e.distance - slope * learned, slope,
            h.dot(covarianceOf(mode) * h) + spread},
           params, focal);
  }
}

}  // namespace kelpie::gps
