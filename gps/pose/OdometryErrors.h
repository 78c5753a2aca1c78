// SPDX-License-Identifier: Apache-2.0
// By what share steps ahead and aside are longer than the odometry tells, and how much faster the
// robot turns while it walks: what a carpet, a gait and worn feet do in every step. Kept with its
// covariance and with that of the best mode's pose, as one Kalman filter would: a doubtful scale
// widens the modes as they move, and what landmarks and lines then tell of the pose tells, by
// regression, of the scale. Wrong where poses are, and in the seconds after the carpet changes.
#pragma once

#include "gps/pose/OdometryErrorsParams.h"
#include "gps/pose/PoseState.h"
#include "gps/pose/Predict.h"

namespace kelpie::gps {

// Nothing is known but how much robots and carpets differ.
OdometryErrors startingErrors(const OdometryErrorsParams& params);

// The step as it was walked, as far as that is known.
Odometry corrected(const Odometry& told, double elapsed, const OdometryErrors& errors);

// Moves the modes as `told` and corrected; adds to their covariances what is not known of that.
void predictAll(const Odometry& told, const Step& step, double elapsed,
                const OdometryErrorsParams& params, PoseState& state);

// At the end of a frame: by what has become of the mode that was the best one after prediction.
// Learns in frames with a landmark; in others their covariance with the pose alone follows.
void learnErrors(const OdometryErrorsParams& params, PoseState& state);

}  // namespace kelpie::gps
