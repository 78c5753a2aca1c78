// SPDX-License-Identifier: Apache-2.0
// The thesis's own minimiser, as a check on the learner (2006 section 2.3.2, checklist A-2.3.2.4):
// Nelder and Mead's simplex over one channel's six coefficients, from no ring effect at all, on
// every eighth pixel with the weights, the colours and the centre that the learner ended with.
#pragma once

#include "tools/calibrate/RingLearner.h"

namespace kelpie::calibrate {

struct SimplexCheck {
  double simplex = 0.0;  // weighted rms residual, grey levels
  double squares = 0.0;  // of the least squares solution on the same pixels
};

SimplexCheck checkWithSimplex(const RingFit& fit, std::size_t channel);

}  // namespace kelpie::calibrate
