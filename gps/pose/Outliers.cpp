// SPDX-License-Identifier: Apache-2.0
#include "gps/pose/Outliers.h"

namespace kelpie::gps {

PoseMode outlierCopy(const PoseMode& mode, double outlierWeight) {
  PoseMode copy = mode;
  copy.weight *= outlierWeight;
  return copy;
}

void countUnexplained(const SplitWeights& weights, double explainedShare, std::size_t sightings,
                      std::uint32_t& unexplained) {
  const double all = weights.copies + weights.corrected;
  const bool explained = weights.corrected > explainedShare * all;
  unexplained = explained ? 0 : unexplained + static_cast<std::uint32_t>(sightings);
}

void countUnexplainedLandmarks(const SplitWeights& weights, const ModeParams& params,
                               std::size_t landmarks, PoseState& state) {
  countUnexplained(weights, params.explainedShare, landmarks, state.unexplained);
  if (params.maxUnexplained == 0 || state.unexplained <= params.maxUnexplained) return;
  state.unexplained = 0;
  state.lost = true;
}

}  // namespace kelpie::gps
