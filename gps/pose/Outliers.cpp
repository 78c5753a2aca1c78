// SPDX-License-Identifier: Apache-2.0
#include "gps/pose/Outliers.h"

#include <algorithm>

namespace kelpie::gps {

double outlierWeightOf(LandmarkKind kind, const ModeParams& params,
                       const SightingRecords& sightings) {
  const auto index = static_cast<std::size_t>(kind);
  double others = 0.0;
  for (std::size_t i = 0; i < sightings.size(); ++i)
    if (i != index) others = std::max(others, sightings[i].believed);
  const double repeated = sightings[index].falseShare * others;
  return params.outlierWeight + repeated * (params.repeatedOutlierWeight - params.outlierWeight);
}

PoseMode outlierCopy(const PoseMode& mode, double outlierWeight) {
  PoseMode copy = mode;
  copy.weight *= outlierWeight;
  return copy;
}

void note(const SplitWeights& weights, SightingRecord& sightings) {
  const double all = weights.copies + weights.corrected;
  if (all > 0.0) sightings = {weights.corrected / all, weights.copies / all};
}

void fade(double elapsed, const ModeParams& params, SightingRecords& sightings) {
  const double left = maths::exp(-elapsed / params.sightingFade);
  for (SightingRecord& record : sightings) {
    record.believed *= left;
    record.falseShare *= left;
  }
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
