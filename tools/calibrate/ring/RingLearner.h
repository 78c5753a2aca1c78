// SPDX-License-Identifier: Apache-2.0
// Learns the ring effect from sheets (thesis 2006 section 2.3.2). Per channel the model F is linear
// in its six coefficients: weighted least squares solves it, with each sheet's colour in the middle
// as one more unknown, because no pixel shows that without noise. The weights are Huber's, then
// Tukey's, so that a finger in the picture counts for nothing; a sheet that stays uneven after the
// fit is left out as a whole. Around that a pattern search finds each channel's centre.
// Fails where the images show no even sheets, and where the sheets' colours do not differ and no
// prior is given: one colour cannot tell gain from offset.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "robot/core/Expected.h"
#include "tools/calibrate/ring/Sheets.h"
#include "vision/colour/RingTable.h"

namespace kelpie::calibrate {

struct RingLearnParams {
  bool findCentre = true;
  double minSpread = 15.0;   // grey levels between the sheets' colours, in each channel
  double maxUneven = 1.5;    // grey levels, rms of a sheet's ring means after the fit
  double unevenRatio = 4.0;  // and that many times the median sheet's
  double maxResidual = 6.0;  // grey levels; the camera's noise is 2 to 3, a scene leaves 10 to 20
  double priorShare = 0.0;   // weight of the 2006 polynomial as a share of all pixels
};

struct ChannelFit {
  vision::RingChannel model;
  Centre centre{};                // where the search ended, not rounded
  std::vector<double> colour;     // of each sheet used, in the middle of the image
  double before = 0.0;            // weighted rms about each sheet's mean, grey levels
  double after = 0.0;             // weighted rms of value - F(colour, distance)
  std::vector<double> weights{};  // of each pixel, sheet by sheet
};

struct RingFit {
  vision::RingModel model;  // centres rounded to pixels, coefficients for the rounded ones
  std::array<ChannelFit, 3> channel;
  std::vector<Sheet> used;
  std::vector<std::string> leftOut;  // names of uneven sheets
};

Expected<RingFit> learnRing(const std::vector<Sheet>& sheets, const RingLearnParams& params);

}  // namespace kelpie::calibrate
