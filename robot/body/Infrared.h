// SPDX-License-Identifier: Apache-2.0
// The infrared sensor at the nose of one robot, so that it may answer whether something is near:
// a straight line makes what the base robot's sensor would read of what this one's does, and a
// reading under the threshold is near (thesis 2006 section 6.4.4). `kelpie calibrate infrared`
// finds them. A threshold holds for one carpet.
#pragma once

#include "robot/core/fields/Fields.h"

namespace kelpie::body {

struct InfraredParams {
  double gain = 1.0;        // of the line; the base robot has 1 and 0
  double offset = 0.0;      // cm
  double threshold = 20.0;  // cm of the base robot's reading; that of the final of 2006

  double asBase(double reading) const { return gain * reading + offset; }

  template <int = 0>
  static constexpr auto fields() {
    using P = InfraredParams;
    return fieldList(field("gain", &P::gain, "", 0.5, 2),
                     field("offset", &P::offset, "cm", -20, 20),
                     field("threshold", &P::threshold, "cm", 5, 50));
  }
};

}  // namespace kelpie::body
