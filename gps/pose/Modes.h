// SPDX-License-Identifier: Apache-2.0
// The mixture of pose hypotheses (thesis 2004 sections 2.1.2 to 2.1.4 and 2.2.3): starting,
// splitting against false sightings, merging, sorting and pruning.
#pragma once

#include "gps/pose/Landmarks.h"
#include "gps/pose/PoseState.h"

namespace kelpie::gps {

// A mode at the middle of the field that fits nearly everything.
PoseMode wideMode(const body::FieldDescription& field, const ModeParams& params, double weight);

// That of the heaviest mode.
CameraTilt tiltOf(const Modes& modes);

// Before the first frame. The modes keep their tilt.
void start(const InitialPose& initial, const body::FieldDescription& field,
           const ModeParams& params, PoseState& state);

// When no hypothesis is left: the wide mode alone.
void lose(const body::FieldDescription& field, const ModeParams& params, PoseState& state);

// Modes around the landmark at the measured distance, each looking so that the measured heading
// fits: the places where a linearised filter can start from one sighting.
void seedAround(const Measurement& measurement, const body::FieldDescription& field,
                const ModeParams& params, PoseState& state, GpsCounts& counts);

// Noise method 3 of thesis 2004 section 2.2.3: adds the wide mode; then corrects each mode, keeping
// a copy that is not corrected with its weight times 1e-2, or more for a landmark that was just
// false (outlierWeightOf). When no mode has predicted many landmarks in a row, the state is lost,
// and the next landmark gives new modes.
void updateAll(const Measurement& measurement, const body::FieldDescription& field,
               const ModeParams& params, PoseState& state, GpsCounts& counts);

// Drops what is not finite (counted), merges, sorts by weight, cuts to kMaxModes, makes the weights
// sum to 1. Loses the pose when nothing is left.
void mergeAndPrune(const body::FieldDescription& field, const ModeParams& params, PoseState& state,
                   GpsCounts& counts);

// One Gaussian with the mean and the covariance of both, their distance included.
PoseMode merged(const PoseMode& a, const PoseMode& b);

}  // namespace kelpie::gps
