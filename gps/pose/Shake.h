// SPDX-License-Identifier: Apache-2.0
// Being pushed about: who stands against another robot is shaken sideways by its steps and does not
// go where its legs walk. Keeps the mean of the sideways acceleration and how far it is from that
// recently; by what goes beyond free walking the way shrinks and its noise grows. Fails where a
// robot is pushed evenly, and after a collision with nobody near: then the noise is there for
// nothing. Does nothing on bodies whose acceleration sensor shows no shaking, as kinematic ones.
#pragma once

#include "gps/pose/PoseState.h"
#include "gps/pose/Predict.h"
#include "robot/core/fields/Fields.h"
#include "robot/core/types/FrameInput.h"

namespace kelpie::gps {

// Learned in the simulated body (docs/decisions.md); a robot needs a `free` of its own.
struct ShakeParams {
  bool use = true;
  double meanSeconds = 0.5;   // over which the acceleration's mean is taken: it leans as it walks
  double shakeSeconds = 0.3;  // and the deviation from it
  double free = 200.0;        // cm/s2 of deviation; 150 shortens a free walk, 0.7 of 3.3 cm
  // For each 100 cm/s2 more:
  double slowing = 0.5;  // k of the way's share 1 / (1 + k excess); turns stay as they are
  double pushed = 40.0;  // cm2/s, both ways
  double turned = 0.1;   // rad2/s

  template <int = 0>
  static constexpr auto fields() {
    using P = ShakeParams;
    return fieldList(field("use", &P::use), field("meanSeconds", &P::meanSeconds, "s", 0.01, 10),
                     field("shakeSeconds", &P::shakeSeconds, "s", 0.01, 10),
                     field("free", &P::free, "cm/s2", 0, 4000),
                     field("slowing", &P::slowing, "", 0, 1000),
                     field("pushed", &P::pushed, "cm2/s", 0, 1e6),
                     field("turned", &P::turned, "rad2/s", 0, 1000));
  }
};

// How much more than free walking shakes the body, in 100 cm/s2; 0 is free. An acceleration that is
// not finite changes nothing. Once a frame.
double excessShake(const FrameInput& input, const ShakeParams& params, ShakeState& state);

// How much it is shaken, in 100 cm/s2; about 1 on walking legs, 0 where no sensor shows it.
double shaking(const ShakeState& state);

// Shortened to 1 / (1 + k excess); the same bits when the excess is 0.
Odometry shortened(const Odometry& odometry, double excess, const ShakeParams& params);

// Grown by pushes and turns of `elapsed` seconds; the same bits when the excess is 0.
StepNoise shaken(const StepNoise& noise, double excess, double elapsed, const ShakeParams& params);

}  // namespace kelpie::gps
