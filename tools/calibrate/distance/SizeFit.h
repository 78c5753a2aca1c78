// SPDX-License-Identifier: Apache-2.0
// The focal length that sizes measured at known distances tell, of ball, beacon and goal together:
// the estimator of BodyEstimate on other sightings. Wrong sizes have little weight; how far an edge
// is measured too far out is one unknown for each object. Measurements that share a series share
// their errors.
#pragma once

#include <array>
#include <string>

#include "tools/calibrate/distance/DistanceData.h"

namespace kelpie::calibrate {

constexpr std::size_t kSizedObjects = 3;  // in the order of SizedObject

struct SizeFit {
  double focalLength = 0.0;  // px
  double focalSd = 0.0;
  std::array<Optics, kSizedObjects> optics;  // of each object
  std::array<Misfit, kSizedObjects> before;  // with the nominal optics
  std::array<Misfit, kSizedObjects> after;
  std::array<std::size_t, kSizedObjects> measured{};
};

// `folder` ends in '/' and holds the three files of ../shared/data/distance. The error names what
// is missing.
Expected<SizeFit> fitSizes(const std::string& folder);

}  // namespace kelpie::calibrate
