// SPDX-License-Identifier: Apache-2.0
// Tunables of the camera's tilt.
#pragma once

#include "robot/core/Angle.h"
#include "robot/core/fields/Fields.h"

namespace kelpie::gps {

struct TiltParams {
  bool use = true;    // otherwise the body stands as its joints say
  bool joint = true;  // keeps what the errors of tilt and pose have in common; off: two filters
  // Tilts of 95 % of the robots are within 3 deg (facts-2005 section 2.1).
  Angle initialSd = Angle::deg(1.5);
  Angle driftSd = Angle::deg(0.4);  // after a second: the neck's play, feet that sink in
  // As much more, for each 100 cm/s2 of shaking (Shake.h): a walking body sways by 1.5 deg at
  // 2 Hz, which is another tilt in each image. Without it lines made the pose worse than landmarks
  // alone (`kelpie evaluate localise`).
  Angle swaySd = Angle::deg(6.0);
  Angle oscillationSd = Angle::deg(0.2);  // of one image: joints' noise, the walking body
  double gate = 3.5;  // standard deviations; beyond, a sighting is something else's
  // Of a robot's accelerometer, which a mean over many images does not make smaller: the sd of one
  // image that leaves this much after ten seconds is 17 times as large [chosen].
  Angle accelerometerSd = Angle::deg(2.0);

  template <int = 0>
  static constexpr auto fields() {
    using P = TiltParams;
    return fieldList(field("use", &P::use), field("joint", &P::joint),
                     field("initialSd", &P::initialSd, "rad", 0.01, 10),
                     field("driftSd", &P::driftSd, "rad", 0, 10),
                     field("swaySd", &P::swaySd, "rad", 0, 30),
                     field("oscillationSd", &P::oscillationSd, "rad", 0.01, 10),
                     field("gate", &P::gate, "", 1, 100),
                     field("accelerometerSd", &P::accelerometerSd, "rad", 0.01, 90));
  }
};

}  // namespace kelpie::gps
