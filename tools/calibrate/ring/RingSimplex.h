// SPDX-License-Identifier: Apache-2.0
// The thesis's own minimiser, as a check on the learner (2006 section 2.3.2, checklist A-2.3.2.4):
// Nelder and Mead's simplex over one channel's six coefficients, from no ring effect at all, on
// every eighth pixel with the weights, the colours and the centre that the learner ended with.
#pragma once

#include <vector>

#include "tools/calibrate/ring/RingLearner.h"

namespace kelpie::calibrate {

// A pixel as the thesis's error sees it: one channel's value at a distance, and what the middle of
// the image shows of the same surface.
struct RingPixel {
  double distance = 0.0;
  double value = 0.0;
  double colour = 0.0;
  double weight = 1.0;
};

// Equations 2.4 and 2.5 for one channel, as a weighted mean.
double meanSquareError(const std::vector<RingPixel>& pixels, const vision::RingChannel& model);

struct SimplexCheck {
  double simplex = 0.0;  // weighted rms residual, grey levels
  double squares = 0.0;  // of the least squares solution on the same pixels
};

SimplexCheck checkWithSimplex(const RingFit& fit, std::size_t channel);

}  // namespace kelpie::calibrate
