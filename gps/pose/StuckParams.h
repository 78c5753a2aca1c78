// SPDX-License-Identifier: Apache-2.0
// Tunables of walking while something holds the robot (thesis 2004 section 2.2.4, checklist U09).
#pragma once

#include <cstdint>

#include "robot/core/fields/Fields.h"

namespace kelpie::gps {

// Learned in the simulated body by `kelpie evaluate stuck` (docs/results.md); a robot needs its
// own: what duty its motors show depends on their wear and on the carpet.
struct StuckParams {
  bool use = true;
  // By the load that the body feels (actuator/feeling/Feeling.h) in place of the effort: that of
  // servos with masses to move says nothing (physics.md section 5), that of kinematic ones feels no
  // load.
  bool byLoad = false;
  double freeEffort = 0.13;          // of walking freely and slowly,
  double effortPerSpeed = 0.0029;    // s/cm, more for each cm/s of the feet, up to 60
  double sidewaysFactor = 1.3;       // cm/s forward that cost as much as 1 sideways
  double turnLever = 13.0;           // cm: the same for 1 rad/s
  double margin = 0.02;              // q0 is that much above the effort of walking freely
  double slowing = 84.0;             // k: the way shrinks to 1 / (1 + k (q - q0))
  double growth = 15.0;              // variances grow by the factor 1 + growth (q - q0),
  double pushed = 400.0;             // and by that times q - q0, cm2/s: others push
  double turned = 0.3;               // rad2/s: and turn
  double pauseAbove = 0.3;           // share of the way lost from which lines are not trusted
  double pauseSeconds = 0.0;         // how long afterwards; 0: lines are never paused
  std::uint32_t pauseLandmarks = 2;  // predicted landmarks that end the pause sooner

  template <int = 0>
  static constexpr auto fields() {
    using P = StuckParams;
    return fieldList(
        field("use", &P::use), field("byLoad", &P::byLoad),
        field("freeEffort", &P::freeEffort, "", 0, 1),
        field("effortPerSpeed", &P::effortPerSpeed, "s/cm", 0, 1),
        field("sidewaysFactor", &P::sidewaysFactor, "", 0, 100),
        field("turnLever", &P::turnLever, "cm", 0, 1000), field("margin", &P::margin, "", 0, 1),
        field("slowing", &P::slowing, "", 0, 1000), field("growth", &P::growth, "", 0, 1e4),
        field("pushed", &P::pushed, "cm2/s", 0, 1e6),
        field("turned", &P::turned, "rad2/s", 0, 1000),
        field("pauseAbove", &P::pauseAbove, "", 0, 1),
        field("pauseSeconds", &P::pauseSeconds, "s", 0, 60),
        field("pauseLandmarks", &P::pauseLandmarks, "", 1, 1000));
  }
};

}  // namespace kelpie::gps
