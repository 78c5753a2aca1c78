// SPDX-License-Identifier: Apache-2.0
// The two calibrations of the head's infrared (thesis 2006 section 6.4.4): a threshold from what
// the base robot reads of the bare carpet as it stands with a ball, and for another robot the
// straight line that makes the base robot's reading of its own. On a new carpet only the base robot
// is measured again. Two sensors whose difference is no line keep what the line leaves (`rms`).
#pragma once

#include "tools/calibrate/infrared/CarpetLog.h"

namespace kelpie::calibrate {

struct CarpetThreshold {
  std::size_t readings = 0;
  double carpet = 0.0;     // cm, their mean, as the base robot reads it
  double threshold = 0.0;  // cm
};

struct InfraredLine {
  std::size_t poses = 0;  // that both have held
  double gain = 1.0;      // base = gain * own + offset
  double offset = 0.0;    // cm
  double rms = 0.0;       // cm, what is left
};

// Errors say in one line what is missing: the stance; two poses with different distances.
Expected<CarpetThreshold> carpetThreshold(const CarpetLog& log);
Expected<InfraredLine> lineBetween(const CarpetLog& own, const CarpetLog& base);

}  // namespace kelpie::calibrate
