// SPDX-License-Identifier: Apache-2.0
// What can be tuned in what the body feels (Falls.h, Feeling.h).
#pragma once

#include <cstdint>

#include "robot/core/Angle.h"
#include "robot/core/fields/Fields.h"

namespace kelpie::actuator {

// Rest poses of the physical body (physics.md section 6), forward, left and up: on the left side
// (0, -900, -400), on the back (510, 0, -840) cm/s2. A walk of 35 cm/s keeps its low passed upward
// part between 930 and 1060 (section 5), so that a lean of 60 deg is far from any walk.
struct FallParams {
  double filterTicks = 20.0;    // of the low pass
  double fallenBelow = 490.0;   // upward part below which a robot lies
  double uprightAbove = 700.0;  // and above which it has got up: 45 deg
  std::uint32_t messages = 5;   // that must agree (facts-2005 section 6.4)

  template <int = 0>
  static constexpr auto fields() {
    using P = FallParams;
    return fieldList(field("filterTicks", &P::filterTicks, "", 1, 200),
                     field("fallenBelow", &P::fallenBelow, "cm/s2", -900, 900),
                     field("uprightAbove", &P::uprightAbove, "cm/s2", -900, 950),
                     field("messages", &P::messages, "", 1, 100));
  }
};

// A ball between chin, chest and forelegs, felt while the head is in the pose that holds one. With
// the ball the neck stands 2 to 6 deg higher than without (physics.md section 10: error 1.8 to 3.0
// and 4.4 deg): the empty head sags by its weight.
struct HeldBallParams {
  Angle neckBelow = Angle::deg(-45.0);   // a commanded neck lower than that,
  Angle mouthBelow = Angle::deg(-40.0);  // and jaw further open, hold
  std::uint32_t ticks = 20;              // of the window: 0.16 s
  Angle sag = Angle::deg(3.2);           // of the empty neck, mean over the window, at least
  double chest = 13.0;  // cm: a ball closer than the chest sensor can tell reads this or more
                        // (facts-2005 section 6.4); empty it reads 10

  template <int = 0>
  static constexpr auto fields() {
    using P = HeldBallParams;
    return fieldList(field("neckBelow", &P::neckBelow, "rad", -75, 0),
                     field("mouthBelow", &P::mouthBelow, "rad", -55, -3),
                     field("ticks", &P::ticks, "", 1, 60), field("sag", &P::sag, "rad", -20, 20),
                     field("chest", &P::chest, "cm", 0, 100));
  }
};

// Whether somebody has lifted the robot. The paws' switches are all open for 0.16 s at most in a
// match of the physical world, and for 0.64 s while one of eight varied models gets up.
struct LiftParams {
  double freeSeconds = 0.25;      // of all paws, until it counts as lifted
  double gettingUpSeconds = 0.9;  // so while it gets up
  double lyingSeconds = 0.4;      // so of one that lies and is moved all the while
  double settles = 3.0;           // s at most until one that lies down is still
  double stillBelow = 60.0;   // cm/s2 that the accelerometer may stray while the robot stands still
  double restSeconds = 0.3;   // of the low pass from which it strays
  double jolt = 0.13;         // s that a movement counts on, of a robot that lies
  double stillSeconds = 1.0;  // until a robot with a pressed paw has been put down
  double stillWithoutPaw = 4.0;  // and one without, upright or on its belly
  double stillOnSide = 10.0;     // and one on a side or its back, which a lap may be under
  double uprightAbove = 700.0;   // cm/s2, the upward part: 45 deg

  template <int = 0>
  static constexpr auto fields() {
    using P = LiftParams;
    return fieldList(field("freeSeconds", &P::freeSeconds, "s", 0.1, 10),
                     field("gettingUpSeconds", &P::gettingUpSeconds, "s", 0.1, 10),
                     field("lyingSeconds", &P::lyingSeconds, "s", 0.1, 10),
                     field("settles", &P::settles, "s", 0, 10),
                     field("stillBelow", &P::stillBelow, "cm/s2", 1, 2000),
                     field("restSeconds", &P::restSeconds, "s", 0.04, 10),
                     field("jolt", &P::jolt, "s", 0, 10),
                     field("stillSeconds", &P::stillSeconds, "s", 0.1, 60),
                     field("stillWithoutPaw", &P::stillWithoutPaw, "s", 0.1, 60),
                     field("stillOnSide", &P::stillOnSide, "s", 0.1, 600),
                     field("uprightAbove", &P::uprightAbove, "cm/s2", -900, 950));
  }
};

// On free ground the load is within 0.03 for 99 % of the time, held it is 0.045 to 0.13.
struct FeelingParams {
  FallParams falls;
  HeldBallParams heldBall;
  LiftParams lift;
  double noLoad = 7.5;            // rad/s of a joint without load (docs/physical-body.md)
  double weight = 0.162;          // of the robot over a joint's greatest torque, 1/cm: 16 N, 1 N m
  double lever = 10.0;            // cm from the middle to the feet, by which a turn counts
  double legLength = 10.0;        // cm, by which a push is a share of the rotators' currents
  double minSpeed = 4.0;          // cm/s of the feet below which no load is estimated
  std::uint32_t delayTicks = 10;  // from a command until the joints do it
  double stuckLoad = 0.038;       // load above which something holds the robot
  double freeLoad = 0.02;         // and below which it is free again
  double stuckSeconds = 0.19;     // for which it must be above
  double airborne = 0.6;          // share of the lift above which a foot is in the air
  std::uint32_t pressTicks = 3;   // for which a paw must be pressed there
  double blockedSeconds = 0.4;    // that it counts: 12 frames (facts-2005 section 6.4)

  template <int = 0>
  static constexpr auto fields() {
    using P = FeelingParams;
    return fieldList(
        field("falls", &P::falls), field("heldBall", &P::heldBall), field("lift", &P::lift),
        field("noLoad", &P::noLoad, "rad/s", 1, 100), field("weight", &P::weight, "1/cm", 0, 10),
        field("lever", &P::lever, "cm", 1, 100), field("legLength", &P::legLength, "cm", 1, 100),
        field("minSpeed", &P::minSpeed, "cm/s", 0.1, 100),
        field("delayTicks", &P::delayTicks, "", 0, 60), field("stuckLoad", &P::stuckLoad, "", 0, 1),
        field("freeLoad", &P::freeLoad, "", 0, 1),
        field("stuckSeconds", &P::stuckSeconds, "s", 0, 10),
        field("airborne", &P::airborne, "", 0, 1), field("pressTicks", &P::pressTicks, "", 1, 30),
        field("blockedSeconds", &P::blockedSeconds, "s", 0, 10));
  }
};

}  // namespace kelpie::actuator
