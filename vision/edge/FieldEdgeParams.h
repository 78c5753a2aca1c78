// SPDX-License-Identifier: Apache-2.0
// Tunables of the scan lines and of the field edge's search and fit.
#pragma once

#include <cstdint>

#include "robot/core/fields/Fields.h"

namespace kelpie::vision {

struct HorizonScanParams {
  double aboveHorizon = 12;  // px that a scan line begins above the horizon, which is noisy
  double denseDepth = 96;    // px below the horizon where every second line ends: 27 deg

  template <int = 0>
  static constexpr auto fields() {
    return fieldList(field("aboveHorizon", &HorizonScanParams::aboveHorizon, "px", -160, 160),
                     field("denseDepth", &HorizonScanParams::denseDepth, "px", 0, 300));
  }
};

struct FieldEdgeParams {
  double window = 8;            // px of a scan line, green below the edge (checklist U01)
  double minGreen = 0.75;       // share of green in it
  double doubtfulWeight = 0.5;  // of a feature below goal colours or white
  double tolerance = 2.25;      // px, of an inlier; the noise is 0.4 px, in checklist E4 1 px
  double abovePenalty = 0.7;    // for each scan line with carpet beyond the edge, in inliers
  double rounds = 10;           // for each edge, checklist
  double minSupport = 8;        // scan lines on all edges, d of thesis 2006 algorithm 3.1
  double minCornerSupport = 4;  // on each of several
  double minCornerScore = 4;    // inliers that a further edge must win
  double minBendRatio = 25;     // of the squares that a bend saves to those of the noise
  // Corners are square on the ground, but a turning head shears the image: of 220 corners seen
  // while turning 162 are found with 0.5 and 196 with 0.9, of 143 seen at rest 130 and 134.
  double maxCornerCosine = 0.9;
  double minShare = 0.35;     // of the scan lines with a feature, all edges together
  std::uint32_t seed = 2006;  // of the sampling, afresh for each image

  template <int = 0>
  static constexpr auto fields() {
    return fieldList(field("window", &FieldEdgeParams::window, "px", 2, 32),
                     field("minGreen", &FieldEdgeParams::minGreen, "", 0, 1),
                     field("doubtfulWeight", &FieldEdgeParams::doubtfulWeight, "", 0, 1),
                     field("tolerance", &FieldEdgeParams::tolerance, "px", 0.5, 20),
                     field("abovePenalty", &FieldEdgeParams::abovePenalty, "", 0, 10),
                     field("rounds", &FieldEdgeParams::rounds, "", 1, 100),
                     field("minSupport", &FieldEdgeParams::minSupport, "", 2, 72),
                     field("minCornerSupport", &FieldEdgeParams::minCornerSupport, "", 2, 72),
                     field("minCornerScore", &FieldEdgeParams::minCornerScore, "", 0, 72),
                     field("minBendRatio", &FieldEdgeParams::minBendRatio, "", 0, 1000),
                     field("maxCornerCosine", &FieldEdgeParams::maxCornerCosine, "", 0, 1),
                     field("minShare", &FieldEdgeParams::minShare, "", 0, 1),
                     field("seed", &FieldEdgeParams::seed));
  }
};

}  // namespace kelpie::vision
