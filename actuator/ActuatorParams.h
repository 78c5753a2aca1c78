// SPDX-License-Identifier: Apache-2.0
// What can be tuned in the actuator. Gait values start from the FastForward set of 2005
// (data/walk/on_robot_sets.csv: half step 22 ticks); lifts are lower and the locus is our own.
#pragma once

#include <cstdint>

#include "robot/core/Angle.h"
#include "robot/core/Fields.h"

namespace kelpie::actuator {

// How the body is carried and where the feet stand, in the robot frame. Found by a random search
// for where the fastest walks in all directions ask the joints for the least per tick: 4.1 deg;
// with feet 8 cm aside the shoulders' limits cut sideways strokes and turns short.
struct StanceParams {
  double shoulderHeight = 10.2;
  Angle bodyTilt = Angle::deg(10.5);
  double frontAhead = 2.0;   // front feet ahead of the neck base
  double frontAside = 9.5;   // and from the middle
  double hindBehind = 13.0;  // hind feet behind the neck base
  double hindAside = 10.1;

  static constexpr auto fields() {
    using P = StanceParams;
    return fieldList(field("shoulderHeight", &P::shoulderHeight, "cm", 5, 14),
                     field("bodyTilt", &P::bodyTilt, "rad", -10, 40),
                     field("frontAhead", &P::frontAhead, "cm", -5, 10),
                     field("frontAside", &P::frontAside, "cm", 4, 12),
                     field("hindBehind", &P::hindBehind, "cm", 8, 20),
                     field("hindAside", &P::hindAside, "cm", 4, 12));
  }
};

struct GaitParams {
  std::uint32_t halfStepTicks = 22;  // each diagonal pair swings once in two half steps
  std::uint32_t swingTicks = 22;     // at most a half step; what is left of it all feet are down
  double frontLift = 1.3;
  double hindLift = 1.3;
  double maxStroke = 5.8;         // way of a foot while it is down; longer requests are scaled
  double acceleration = 90.0;     // of the requested speed
  double turnAcceleration = 9.0;  // of the requested turn

  static constexpr auto fields() {
    using P = GaitParams;
    return fieldList(field("halfStepTicks", &P::halfStepTicks, "", 8, 60),
                     field("swingTicks", &P::swingTicks, "", 4, 60),
                     field("frontLift", &P::frontLift, "cm", 0.5, 4),
                     field("hindLift", &P::hindLift, "cm", 0.5, 5),
                     field("maxStroke", &P::maxStroke, "cm", 1, 12),
                     field("acceleration", &P::acceleration, "cm/s2", 10, 1000),
                     field("turnAcceleration", &P::turnAcceleration, "rad/s2", 1, 100));
  }
};

// What really comes of a commanded speed, and how much later: joints follow their targets late, and
// feet that lift or land still touch the ground (measured in the simulated world, README).
struct OdometryScales {
  double forward = 0.917;
  double left = 0.92;
  double turn = 0.92;

  static constexpr auto fields() {
    using P = OdometryScales;
    return fieldList(field("forward", &P::forward, "", 0.2, 2), field("left", &P::left, "", 0.2, 2),
                     field("turn", &P::turn, "", 0.2, 2));
  }
};

// One set for each gain of the leg joints (thesis 2004 section 2.2.4).
struct OdometryParams {
  OdometryScales high;
  OdometryScales low{0.797, 0.520, 0.415};
  std::uint32_t delayTicks = 10;  // two command vectors in flight and the servos' lag

  static constexpr auto fields() {
    using P = OdometryParams;
    return fieldList(field("high", &P::high), field("low", &P::low),
                     field("delayTicks", &P::delayTicks, "", 0, 24));
  }
};

// When the leg joints are held weakly, to keep the battery's current below what makes OPEN-R shut
// the robot down. Currents of facts-2005 section 2.5; ours are means over some seconds.
struct GainParams {
  double lowAbove = 3500.0;   // mA
  double highBelow = 2500.0;  // mA
  double seconds = 2.0;       // of the mean

  static constexpr auto fields() {
    using P = GainParams;
    return fieldList(field("lowAbove", &P::lowAbove, "mA", 0, 2e4),
                     field("highBelow", &P::highBelow, "mA", 0, 2e4),
                     field("seconds", &P::seconds, "s", 0.01, 100));
  }
};

// The chest push. Ways are those of the body over feet that stay where they are.
struct KickParams {
  double leanBack = 3.0;
  double pushAhead = 6.0;  // beyond the place where it began
  std::uint32_t leanTicks = 18;
  std::uint32_t pushTicks = 9;  // 9 cm in 72 ms from rest: 2.5 m/s commanded, servos give half
  std::uint32_t holdTicks = 8;
  std::uint32_t returnTicks = 22;

  static constexpr auto fields() {
    using P = KickParams;
    return fieldList(field("leanBack", &P::leanBack, "cm", 0, 6),
                     field("pushAhead", &P::pushAhead, "cm", 0, 6),
                     field("leanTicks", &P::leanTicks, "", 2, 100),
                     field("pushTicks", &P::pushTicks, "", 2, 100),
                     field("holdTicks", &P::holdTicks, "", 0, 100),
                     field("returnTicks", &P::returnTicks, "", 2, 100));
  }
};

struct ActuatorParams {
  StanceParams stance;
  GaitParams gait;
  KickParams kick;
  OdometryParams odometry;
  GainParams gain;
  double rampSeconds = 1.0;             // from the sensed pose to the stance
  Angle walkSlew = Angle::deg(4.0);     // per tick, legs while walking
  Angle motionSlew = Angle::deg(20.0);  // per tick, legs in a special motion
  Angle headSlew = Angle::deg(4.0);     // per tick

  static constexpr auto fields() {
    using P = ActuatorParams;
    return fieldList(field("stance", &P::stance), field("gait", &P::gait), field("kick", &P::kick),
                     field("odometry", &P::odometry), field("gain", &P::gain),
                     field("rampSeconds", &P::rampSeconds, "s", 0.2, 10),
                     field("walkSlew", &P::walkSlew, "rad", 0.5, 20),
                     field("motionSlew", &P::motionSlew, "rad", 0.5, 40),
                     field("headSlew", &P::headSlew, "rad", 0.5, 20));
  }
};

}  // namespace kelpie::actuator
