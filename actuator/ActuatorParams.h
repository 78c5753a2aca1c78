// SPDX-License-Identifier: Apache-2.0
// What can be tuned in the actuator. Walks and motions are data of their own (actuator/data).
#pragma once

#include "actuator/feeling/FeelingParams.h"
#include "actuator/motion/MotionData.h"
#include "actuator/walk/WalkSet.h"

namespace kelpie::actuator {

// Commands become movement this much later: two command vectors are in flight and the servos lag.
// And how far the odometry may be wrong, as variances that grow with the way.
struct OdometryParams {
  std::uint32_t delayTicks = 10;
  double alongPerCm = 0.1;      // cm2 along the walking direction per cm walked
  double acrossPerCm = 0.0625;  // cm2 across it per cm walked
  double turnPerRad = 3e-3;     // rad2 per rad turned: sd 8 deg in 360; varied models differ by 7
  double turnPerCm = 0.625e-5;  // rad2 per cm walked
  double positionPerRad = 0.5;  // cm2 per rad turned

  template <int = 0>
  static constexpr auto fields() {
    using P = OdometryParams;
    return fieldList(field("delayTicks", &P::delayTicks, "", 0, 24),
                     field("alongPerCm", &P::alongPerCm, "cm", 0, 100),
                     field("acrossPerCm", &P::acrossPerCm, "cm", 0, 100),
                     field("turnPerRad", &P::turnPerRad, "rad", 0, 10),
                     field("turnPerCm", &P::turnPerCm, "rad2/cm", 0, 1),
                     field("positionPerRad", &P::positionPerRad, "cm2/rad", 0, 1000));
  }
};

// When the leg joints are held weakly, to keep the battery's current below what makes OPEN-R shut
// the robot down. Currents of facts-2005 section 2.5; ours are means over some seconds.
struct GainParams {
  double lowAbove = 3500.0;   // mA
  double highBelow = 2500.0;  // mA
  double seconds = 2.0;       // of the mean

  template <int = 0>
  static constexpr auto fields() {
    using P = GainParams;
    return fieldList(field("lowAbove", &P::lowAbove, "mA", 0, 2e4),
                     field("highBelow", &P::highBelow, "mA", 0, 2e4),
                     field("seconds", &P::seconds, "s", 0.01, 100));
  }
};

struct ActuatorParams {
  WalkSets walks = standardWalks();
  Motions motions = standardMotions();
  OdometryParams odometry;
  GainParams gain;
  FeelingParams feeling;
  double rampSeconds = 1.0;            // from the sensed pose to the stance, or longer by startRate
  Angle startRate = Angle::deg(60.0);  // per second, of any joint on that way
  double mixSeconds = 0.3;             // from one walk to another
  Angle walkSlew = Angle::deg(4.0);    // per tick, legs while walking (facts-2005 section 6.4)
  Angle headSlew = Angle::deg(4.0);    // per tick
  // A body with masses: it sways as it walks, and its load tells of the carpet (BodyOscillation.h,
  // Odometry.h).
  bool physical = true;
  double earSeconds = 1.0;  // an ear asked up for longer goes down (openr.md 5.6)

  template <int = 0>
  static constexpr auto fields() {
    using P = ActuatorParams;
    return fieldList(
        field("walks", &P::walks), field("motions", &P::motions), field("odometry", &P::odometry),
        field("gain", &P::gain), field("feeling", &P::feeling),
        field("rampSeconds", &P::rampSeconds, "s", 0.2, 10),
        field("startRate", &P::startRate, "rad", 5, 170),
        field("mixSeconds", &P::mixSeconds, "s", 0.01, 10),
        field("walkSlew", &P::walkSlew, "rad", 0.5, 20),
        field("headSlew", &P::headSlew, "rad", 0.5, 20), field("physical", &P::physical),
        field("earSeconds", &P::earSeconds, "s", 0, 10));
  }
};

}  // namespace kelpie::actuator
