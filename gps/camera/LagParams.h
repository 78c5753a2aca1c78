// SPDX-License-Identifier: Apache-2.0
// Tunables of the images' lag.
#pragma once

#include "robot/core/Angle.h"
#include "robot/core/fields/Fields.h"

namespace kelpie::gps {

struct LagParams {
  bool use = true;              // otherwise images are as old as their stamps say
  double initial = 0.0;         // s, of this robot (`kelpie calibrate time`)
  double initialSd = 0.04;      // s, somewhat more than a frame
  double min = -0.08;           // s; joints are older than images by two frames and a half
  double max = 0.13;            // s, images by nearly four
  double minRateChange = 1.0;   // rad/s, of a sighting from the mean of the landmark's before
  double maxPairSeconds = 1.0;  // over which that mean goes
  double gate = 4.0;            // standard deviations

  template <int = 0>
  static constexpr auto fields() {
    using P = LagParams;
    return fieldList(field("use", &P::use), field("initial", &P::initial, "s", -0.1, 0.2),
                     field("initialSd", &P::initialSd, "s", 1e-4, 1),
                     field("min", &P::min, "s", -0.1, 0), field("max", &P::max, "s", 0, 0.2),
                     field("minRateChange", &P::minRateChange, "rad/s", 0.1, 10),
                     field("maxPairSeconds", &P::maxPairSeconds, "s", 0, 10),
                     field("gate", &P::gate, "", 1, 100));
  }
};

}  // namespace kelpie::gps
