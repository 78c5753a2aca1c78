// SPDX-License-Identifier: Apache-2.0
#include "gps/camera/Focal.h"

#include <cmath>

#include "gps/Gaussian.h"
#include "gps/pose/PoseUpdate.h"

namespace kelpie::gps {
namespace {

constexpr double kKnownSd = 1e-4;  // where it is not estimated

// An innovation, how much of it one unit of the scale explains, and its variance without the
// scale's.
struct Sighting {
  double innovation = 0.0;
  double slope = 0.0;
  double variance = 0.0;
};

void update(const Sighting& z, const FocalParams& params, FocalScale& focal) {
  const double variance = z.slope * z.slope * focal.variance + z.variance;
  if (!(z.innovation * z.innovation <= maths::square(params.gate) * variance)) return;
  const double gain = z.slope * focal.variance / variance;
  focal.ratio = maths::clamp(focal.ratio + gain * z.innovation, 1.0 - params.max, 1.0 + params.max);
  focal.variance = std::fmax(focal.variance * (1.0 - gain * z.slope), maths::square(params.minSd));
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
