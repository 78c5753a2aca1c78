// SPDX-License-Identifier: Apache-2.0
// The field edge as thesis 2006 sections 3.2.2 to 3.3 fits it, kept for comparison only: rounds of
// regression on n sampled points, widened to all points near the line, judged by the correlation
// |r| or by their number. |r| goes to 0 on a level edge however good the fit (checklist G12), and
// eight points are seldom all good (G11): EdgeFit.h is what the robot uses.
#pragma once

#include <optional>

#include "vision/edge/EdgeFeatures.h"

namespace kelpie::baselines {

enum class EdgeFitness { correlation, count };

struct CorrelationParams {
  int points = 8;  // "minimal of 8 data points": read literally, n; 2 is the other reading
  EdgeFitness fitness = EdgeFitness::correlation;
  double tolerance = 4.0;  // px
  int minSupport = 8;
  int rounds = 10;
  double stopAboveCorrelation = 0.85;  // |r| that ends the search
  double minCorrelation = 0.55;        // |r| below which there is no edge
  std::uint32_t seed = 2006;
};

struct SlopeLine {
  double slope = 0.0;
  double offset = 0.0;  // row at x = 0
  double r = 0.0;       // thesis 2006 equation 3.4
};

SlopeLine regression(const vision::EdgeFeatures& points);
std::optional<SlopeLine> correlationEdge(const vision::EdgeFeatures& points,
                                         const CorrelationParams& params);

}  // namespace kelpie::baselines
