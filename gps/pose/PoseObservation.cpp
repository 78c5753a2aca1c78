// SPDX-License-Identifier: Apache-2.0
#include "gps/pose/PoseObservation.h"

#include <algorithm>

namespace kelpie::gps {

void correct(PoseMode& mode, const PoseObservation& observation) {
  const Matrix3 p = covarianceOf(mode);
  const Matrix3 sum = Matrix3::Identity() + p * observation.information;
  const Matrix3 a = sum.inverse();
  Vector3 innovation(observation.pose.position.x - mode.pose.position.x,
                     observation.pose.position.y - mode.pose.position.y,
                     (observation.pose.heading - mode.pose.heading).rad());
  const Matrix3 spread = observation.information * a;
  mode.weight *= maths::exp(-0.5 * std::max(0.0, innovation.dot(spread * innovation)));
  mode.pose = poseOf(meanOf(mode) + a * p * observation.information * innovation);
  setCovariance(mode, a * p);
}

}  // namespace kelpie::gps
