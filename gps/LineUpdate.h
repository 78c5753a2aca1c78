// SPDX-License-Identifier: Apache-2.0
// Corrects the likely modes by the field lines (thesis 2004 section 3.3). Each likely mode gets the
// pose near it at which the lines match best, as an observation of the pose itself whose
// information is the match's curvature: along a lone straight line it is zero, so that direction
// stays as it was. A copy without the correction stays for the case that other lines were seen.
#pragma once

#include "gps/GpsParams.h"
#include "gps/GpsState.h"
#include "gps/LineFit.h"

namespace kelpie::gps {

// An observation of the pose. Singular where the lines say nothing.
struct PoseObservation {
  Pose2 pose;
  Matrix3 information;
};

// Kalman update in information form, valid for singular information: A = (1 + P L)^-1,
// gain = A P L, P' = A P. Multiplies the weight by S in (0, 1] (equation 2.9).
void correct(PoseMode& mode, const PoseObservation& observation);

// The fit as an observation: none when it matches worse than equation 3.22 requires or lies off the
// field (3.20, 3.21); wider the faster the head moves (3.23).
std::optional<PoseObservation> observationOf(const LineFit& fit, const FieldFeatures& field,
                                             double headSpeed, const LineUpdateParams& params);

// The observation by a fit near one mode; none for a mode that is too wide for a fit, or near which
// the lines match nothing (counted).
std::optional<PoseObservation> observationAt(const PoseMode& mode, const SeenLines& seen,
                                             double headSpeed, const GpsParams& params,
                                             GpsState& state);

// Weight factor of a mode without such an observation when another mode has one.
double weightWithoutLineFit(const PoseMode& mode, const SeenLines& seen,
                            const LineUpdateParams& params);

// Returns whether any mode was corrected. Call mergeAndPrune() afterwards.
bool updateByLines(const SeenLines& seen, double headSpeed, const GpsParams& params,
                   GpsState& state);

}  // namespace kelpie::gps
