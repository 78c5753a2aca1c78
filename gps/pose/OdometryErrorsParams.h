// SPDX-License-Identifier: Apache-2.0
// Tunables of the odometry's errors that last.
#pragma once

#include "robot/core/Angle.h"
#include "robot/core/fields/Fields.h"

namespace kelpie::gps {

struct OdometryErrorsParams {
  bool use = true;             // otherwise steps are as long as the odometry tells
  double scaleSd = 0.08;       // of steps ahead and aside, at the start
  double turnSd = 0.025;       // rad/s while walking, at the start
  double scaleDrift = 0.01;    // sd that comes with each second's square root
  double turnDrift = 0.01;     // rad/s, so
  double max = 0.5;            // of a scale's error
  double maxTurn = 0.5;        // rad/s
  double gate = 4.0;           // standard deviations; a pose that moves farther is another mode's
  double othersFrames = 10.0;  // over which errors of the modes but the best one add up

  template <int = 0>
  static constexpr auto fields() {
    using P = OdometryErrorsParams;
    return fieldList(
        field("use", &P::use), field("scaleSd", &P::scaleSd, "", 0, 1),
        field("turnSd", &P::turnSd, "rad/s", 0, 3), field("scaleDrift", &P::scaleDrift, "", 0, 1),
        field("turnDrift", &P::turnDrift, "rad/s", 0, 3), field("max", &P::max, "", 0, 0.9),
        field("maxTurn", &P::maxTurn, "rad/s", 0, 3), field("gate", &P::gate, "", 1, 100),
        field("othersFrames", &P::othersFrames, "", 0, 1000));
  }
};

}  // namespace kelpie::gps
