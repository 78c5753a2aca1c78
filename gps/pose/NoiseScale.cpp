// SPDX-License-Identifier: Apache-2.0
#include "gps/pose/NoiseScale.h"

#include <cmath>

#include "robot/core/Maths.h"

namespace kelpie::gps {

void noteInnovation(const PoseMode& mode, double squared, const NoiseScaleParams& params,
                    double& scale) {
  if (!params.use || !(squared >= 0.0)) return;
  if (mode.covariance[0] + mode.covariance[4] > 2.0 * maths::square(params.maxSd)) return;
  const double size = std::fmin(std::sqrt(squared), params.farthest);
  const double change = maths::exp(params.rate * (size - params.usual));
  scale = maths::clamp(scale * change, params.min, params.max);
}

}  // namespace kelpie::gps
