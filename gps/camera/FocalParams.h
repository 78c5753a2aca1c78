// SPDX-License-Identifier: Apache-2.0
// Tunables of the focal length's scale.
#pragma once

#include "robot/core/Angle.h"
#include "robot/core/fields/Fields.h"

namespace kelpie::gps {

struct FocalParams {
  bool use = true;           // otherwise the focal length is what the body's parameters say
  double initialSd = 0.025;  // lenses of one make differ by 4 % and less
  double max = 0.08;         // of the scale from 1
  double minSd = 0.004;      // however many sightings agree
  double distanceSd = 0.03;  // share of a distance, of one sighting
  Angle maxHeadingSd = Angle::deg(6);  // of the mode
  double gate = 4.0;                   // standard deviations

  template <int = 0>
  static constexpr auto fields() {
    using P = FocalParams;
    return fieldList(field("use", &P::use), field("initialSd", &P::initialSd, "", 1e-4, 0.2),
                     field("max", &P::max, "", 0, 0.3), field("minSd", &P::minSd, "", 1e-5, 0.1),
                     field("distanceSd", &P::distanceSd, "", 0, 10),
                     field("maxHeadingSd", &P::maxHeadingSd, "rad", 0.1, 90),
                     field("gate", &P::gate, "", 1, 100));
  }
};

}  // namespace kelpie::gps
