// SPDX-License-Identifier: Apache-2.0
// Tunables of the images' lag.
#pragma once

#include "robot/core/Angle.h"
#include "robot/core/fields/Fields.h"

namespace kelpie::gps {

struct LagParams {
  bool use = true;                     // otherwise images are as old as their stamps say
  double initialSd = 0.012;            // s: a third of a frame
  double max = 0.05;                   // s, one frame and a half
  double minPanRate = 0.5;             // rad/s; slower heads say nothing of it
  Angle maxHeadingSd = Angle::deg(6);  // of the mode
  double gate = 4.0;                   // standard deviations

  template <int = 0>
  static constexpr auto fields() {
    using P = LagParams;
    return fieldList(field("use", &P::use), field("initialSd", &P::initialSd, "s", 1e-4, 1),
                     field("max", &P::max, "s", 0, 0.06),
                     field("minPanRate", &P::minPanRate, "rad/s", 0.01, 10),
                     field("maxHeadingSd", &P::maxHeadingSd, "rad", 0.1, 90),
                     field("gate", &P::gate, "", 1, 100));
  }
};

}  // namespace kelpie::gps
