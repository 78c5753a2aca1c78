// SPDX-License-Identifier: Apache-2.0
// The rules of play as numbers, beside the field that they go with: what the referee counts and
// what behaviours keep to (checklist M05; facts-2005 section 1 for the throw-in).
#pragma once

#include <cstdint>

#include "robot/core/fields/Fields.h"

namespace kelpie::body {

struct Rules {
  std::uint8_t robotsASide = 4;
  double halfTime = 600.0;        // s of play
  double readyTime = 45.0;        // s to walk to the places for a kick-off
  double penaltyTime = 30.0;      // s off the field for a foul
  double holdingTime = 3.0;       // s that a robot may hold the ball
  double holdingDistance = 50.0;  // cm that it may carry it
  double throwInFromSide = 40.0;  // cm from the side line, where a ball that went out is put
  double throwInFromEnd = 100.0;  // cm from the goal line at least
  // What the rule book leaves to the referee's eye is marked [chosen].
  double initialTime = 5.0;     // s before each half's first kick-off [chosen]
  double readyStill = 2.0;      // s that all stand in legal places, which ends ready early [chosen]
  double setTime = 3.0;         // s between the places taken and the whistle [chosen]
  double ownBoxTime = 1.0;      // s of a forward in its own goal box [chosen]
  double leavingTime = 1.0;     // s of a robot off the carpet [chosen]
  double pushingTime = 3.0;     // s that a robot may push another
  double fallenTime = 20.0;     // s that a fallen robot has to get up [chosen]
  double stuckTime = 25.0;      // s of robots at a ball that goes nowhere [chosen]
  double stuckDistance = 10.0;  // cm that it must go [chosen]
  double stuckReach = 50.0;     // cm from the ball to who is at it [chosen]

  template <int = 0>
  static constexpr auto fields() {
    return fieldList(field("robotsASide", &Rules::robotsASide, "", 1, 11),
                     field("halfTime", &Rules::halfTime, "s", 1, 3600),
                     field("readyTime", &Rules::readyTime, "s", 0, 600),
                     field("penaltyTime", &Rules::penaltyTime, "s", 0, 600),
                     field("holdingTime", &Rules::holdingTime, "s", 0, 60),
                     field("holdingDistance", &Rules::holdingDistance, "cm", 0, 500),
                     field("throwInFromSide", &Rules::throwInFromSide, "cm", 0, 500),
                     field("throwInFromEnd", &Rules::throwInFromEnd, "cm", 0, 500),
                     field("initialTime", &Rules::initialTime, "s", 0, 600),
                     field("readyStill", &Rules::readyStill, "s", 0, 60),
                     field("setTime", &Rules::setTime, "s", 0, 60),
                     field("ownBoxTime", &Rules::ownBoxTime, "s", 0, 60),
                     field("leavingTime", &Rules::leavingTime, "s", 0, 60),
                     field("pushingTime", &Rules::pushingTime, "s", 0, 60),
                     field("fallenTime", &Rules::fallenTime, "s", 0, 600),
                     field("stuckTime", &Rules::stuckTime, "s", 1, 600),
                     field("stuckDistance", &Rules::stuckDistance, "cm", 0, 100),
                     field("stuckReach", &Rules::stuckReach, "cm", 0, 500));
  }
};

}  // namespace kelpie::body
