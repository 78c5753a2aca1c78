// SPDX-License-Identifier: Apache-2.0
// What the battery and the switches last said, in Kelpie's words (OPENR/OPower.h has the bits).
#pragma once

#include "robot/core/fields/Fields.h"

namespace kelpie::agent {

struct PowerReport {
  bool paused = false;       // the pause switch was pressed
  bool batteryLow = false;   // too little is left, or the battery wants to end
  bool overCurrent = false;  // the battery gives more than it should
  bool hot = false;          // the battery
  bool fanFault = false;     // of the fan that cools the processor
  bool motorPower = false;   // the motors are powered; not before the system has said so, and not
                             // after the robot has cut it for a jam
  double current = 0.0;      // drawn from the battery, mA
  double charge = 1.0;       // share of a full battery that is left

  template <int = 0>
  static constexpr auto fields() {
    using P = PowerReport;
    return fieldList(field("paused", &P::paused), field("batteryLow", &P::batteryLow),
                     field("overCurrent", &P::overCurrent), field("hot", &P::hot),
                     field("fanFault", &P::fanFault), field("motorPower", &P::motorPower),
                     field("current", &P::current, "mA", 0, 2e5),
                     field("charge", &P::charge, "", 0, 1));
  }
};

}  // namespace kelpie::agent
