// SPDX-License-Identifier: Apache-2.0
// What a robot's own sensors tell of the world in one tick: joints, motor duty, three distance
// sensors, acceleration, paw and chin switches, head and back buttons. A paw is pressed by the
// ground that it stands on and by what its leg pushes into; one pressed while it swings has hit
// something.
#pragma once

#include "robot/core/Random.h"
#include "robot/core/types/Motion.h"
#include "tools/sim/bodies/Bodies.h"
#include "tools/sim/bodies/Randomisation.h"
#include "tools/sim/world/Ball.h"

namespace kelpie::sim {

struct SensorParams {
  double distanceNoise = 0.03;  // share of the distance, sd
  double accelerationSd = 25.0;
  double idleCurrent = 700.0;      // mA, of all but the legs
  double currentPerDuty = 1500.0;  // mA more for each leg joint at full duty
  // Of physical servos, whose power goes with the square of what they give: a walk at full speed
  // draws 2200 mA [chosen: below the 2500 at which legs get strong again, facts-2005 section 2.5].
  double currentPerSquare = 280.0;
  double capacity = 2200.0;  // mAh of a full battery [chosen]; no public source tells the ERA-7B1's

  template <int = 0>
  static constexpr auto fields() {
    using P = SensorParams;
    return fieldList(field("distanceNoise", &P::distanceNoise, "", 0, 0.5),
                     field("accelerationSd", &P::accelerationSd, "cm/s2", 0, 500),
                     field("idleCurrent", &P::idleCurrent, "mA", 0, 1e4),
                     field("currentPerDuty", &P::currentPerDuty, "mA", 0, 1e4),
                     field("currentPerSquare", &P::currentPerSquare, "mA", 0, 1e4),
                     field("capacity", &P::capacity, "mAh", 1, 1e5));
  }
};

// What the sensors of one robot can meet.
struct Surroundings {
  Ball ball;
  const std::vector<Obstacle>& obstacles;
  const std::vector<BodyPlace>& robots;
  std::size_t self;
};

SensorFrame sense(const Surroundings& around, const BodyFeeling& feeling,
                  const SensorParams& params, Random& random, const NoseSensor& nose = {});

// Of the chest's sensor, cm; what is closer than 7 cm reads too far.
double chestDistance(const Surroundings& around, double noise, Random& random);

// Drawn from the battery: a kinematic motor's current goes with its duty. Mean over the ticks, mA.
double batteryCurrent(const std::array<SensorFrame, kTicksPerMessage>& ticks,
                      const SensorParams& params, bool physical = false);

// What is left of a battery's charge, a share of a full one, after so many mA for so many seconds.
double drained(double charge, double current, double seconds, const SensorParams& params);

// Distance along a ray to the first of ground, ball, obstacle up to 30 cm high, other robot.
double rayDistance(const Surroundings& around, FieldPoint3 from, FieldPoint3 direction);

}  // namespace kelpie::sim
