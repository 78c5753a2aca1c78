// SPDX-License-Identifier: Apache-2.0
// Corrects the likely modes by the field lines (thesis 2004 section 3.3). Each likely mode gets the
// pose near it at which the lines match best, as an observation of the pose itself whose
// information is the match's curvature: along a lone straight line it is zero, so that direction
// stays as it was. A copy without the correction stays for the case that other lines were seen.
// With LineUse::sanity the observation changes the weight alone.
#pragma once

#include "gps/lines/LineFit.h"
#include "gps/pose/PoseState.h"
#include "gps/pose/PoseUpdate.h"

namespace kelpie::gps {

// A fit as an observation of the whole state.
struct LineObservation {
  PoseObservation pose;  // the tilt's doubt taken from its information
  CameraTilt tilt;
  Matrix5 information;  // of pose and tilt together
  Vector2 tiltPull;     // LineFit
  // Weight factor of how well the points match: 1 where all do, that of a refused fit where they
  // match as badly as they may. A wrong pose beside a lone landmark matches, too, but worse.
  double matchFactor = 1.0;
};

// A mode after it: as `corrected` by a pose, of five states.
PoseMode corrected(const PoseMode& mode, const LineObservation& observation);

// The fit as an observation: none when it matches worse than it must (thesis 2004 equation 3.22) or
// lies off the field (thesis 2004 equations 3.20 and 3.21); wider the faster the head moves (thesis
// 2004 equation 3.23).
std::optional<LineObservation> observationOf(const LineFit& fit, const FieldFeatures& field,
                                             double headSpeed, const LineUpdateParams& params);

// The observation by a fit near one mode; none for a mode that is too wide for a fit, or near which
// the lines match nothing (counted).
std::optional<LineObservation> observationAt(const PoseMode& mode, const SeenLines& seen,
                                             const FieldFeatures& field,
                                             const LineUpdateParams& params, GpsCounts& counts);

// Weight factor of a mode without such an observation when another mode has one.
double weightWithoutLineFit(const PoseMode& mode, const SeenLines& seen,
                            const LineUpdateParams& params);

// Returns the heaviest mode's squared innovation over its variance, a mean over three degrees of
// freedom; none where no mode was corrected, or judged. Call mergeAndPrune() afterwards.
std::optional<double> updateByLines(const SeenLines& seen, const FieldFeatures& field,
                                    const LineUpdateParams& params, Modes& modes,
                                    GpsCounts& counts);

}  // namespace kelpie::gps
