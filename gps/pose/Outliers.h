// SPDX-License-Identifier: Apache-2.0
// False sightings (thesis 2004 section 2.2.3). A mode that a sighting corrects leaves a copy that
// it does not, for the case that the sighting is false. Where the corrected modes hold hardly any
// of the weight, no mode has predicted the sighting; after many such in a row the robot is
// elsewhere.
#pragma once

#include "gps/pose/PoseParams.h"
#include "gps/pose/PoseState.h"

namespace kelpie::gps {

// How false the next sighting of that landmark may be: what hides half of it does so in the next
// frame, too. Two sightings of one landmark are no two witnesses.
double outlierWeightOf(LandmarkKind kind, const ModeParams& params,
                       const SightingRecords& sightings);

PoseMode outlierCopy(const PoseMode& mode, double outlierWeight);

// Of all modes after a sighting.
struct SplitWeights {
  double corrected = 0.0;
  double copies = 0.0;
};

void note(const SplitWeights& weights, SightingRecord& sightings);
void fade(double elapsed, const ModeParams& params, SightingRecords& sightings);

// Counts on, or from 0 again when modes of `explainedShare` of all weight predicted the sightings.
void countUnexplained(const SplitWeights& weights, double explainedShare, std::size_t sightings,
                      std::uint32_t& unexplained);

// The same for landmarks; after more than maxUnexplained in a row the pose is lost; never with 0.
void countUnexplainedLandmarks(const SplitWeights& weights, const ModeParams& params,
                               std::size_t landmarks, PoseState& state);

}  // namespace kelpie::gps
