// SPDX-License-Identifier: Apache-2.0
// The thesis' mode sampling (thesis 2004 section 3.3.4), kept to repeat its negative result; not
// used in the frame loop. The match is sampled at 27 poses, one standard deviation of a mode apart,
// and each that is higher than its neighbours becomes an observation by fits of a Gaussian along
// each axis.
#pragma once

#include <optional>

#include "gps/lines/LineFit.h"
#include "gps/pose/PoseState.h"

namespace kelpie::gps {

// Where along an axis the peak is and how wide, in units of the samples' distance.
struct Gaussian1d {
  double mean = 0.0;
  double sd = 0.0;  // a standard deviation, not a variance (checklist H12)
};

// Thesis 2004 equations 3.24 and 3.25, of the values at -1, 0 and 1; none if they do not bend down.
std::optional<Gaussian1d> fitPeak(double before, double here, double after);
// Thesis 2004 equation 3.26, of the values at 0 and 1, the higher one: the top is there.
std::optional<Gaussian1d> fitEdgePeak(double inside, double edge);

// All modes by all of their peaks, with uncorrected copies; the peaks' standard deviations are at
// least `floorSd` (cm) and `floorHeadingSd`, 0 as in the thesis. Call mergeAndPrune() afterwards.
struct SamplingFloor {
  double sd = 0.0;
  Angle headingSd;
};
bool updateBySampling(const SeenLines& seen, const SamplingFloor& floor, const FieldFeatures& field,
                      const LineUpdateParams& params, Modes& modes);

}  // namespace kelpie::gps
