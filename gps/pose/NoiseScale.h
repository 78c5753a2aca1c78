// SPDX-License-Identifier: Apache-2.0
// How many times as large as the parameters say the variances of odometry, landmarks and lines are,
// by the innovations that the best mode sees: robots and fields differ (a worn joint, another
// lens), and with one set of variances the same covariance would be four times too large on a sound
// robot or too small on a worn one. All variances share one factor, so that the gain stays. Slow:
// halved in 10 s; rises faster. Wrong where errors repeat from frame to frame much more
// than usual, for these are not in the innovations.
#pragma once

#include "robot/core/fields/Fields.h"
#include "robot/core/types/WorldModel.h"

namespace kelpie::gps {

struct NoiseScaleParams {
  bool use = true;
  // Innovations over their standard deviations, on average. 0.8 would be one of errors that are
  // new in every frame; those of successive frames repeat, and are then larger than they look.
  double usual = 0.5;
  double rate = 0.003;  // by an innovation, of the scale's logarithm
  double min = 0.25;
  double max = 4.0;
  double maxSd = 20.0;    // cm, of the mode; a wider one expects any sighting
  double farthest = 3.0;  // an innovation counts as no larger; a false sighting's is

  template <int = 0>
  static constexpr auto fields() {
    using P = NoiseScaleParams;
    return fieldList(field("use", &P::use), field("usual", &P::usual, "", 0.01, 1),
                     field("rate", &P::rate, "", 0, 0.1), field("min", &P::min, "", 0.01, 1),
                     field("max", &P::max, "", 1, 100), field("maxSd", &P::maxSd, "cm", 0, 1000),
                     field("farthest", &P::farthest, "", 1, 100));
  }
};

// By one squared innovation of a mode over its variance, a mean over its degrees of freedom.
void noteInnovation(const PoseMode& mode, double squared, const NoiseScaleParams& params,
                    double& scale);

}  // namespace kelpie::gps
