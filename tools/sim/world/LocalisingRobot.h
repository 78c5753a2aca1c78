// SPDX-License-Identifier: Apache-2.0
// An observer with a localiser that gets all of what it sees and feels.
#pragma once

#include "gps/Localiser.h"
#include "tools/sim/world/Observer.h"

namespace kelpie::sim {

class LocalisingRobot : public Observer {
 public:
  explicit LocalisingRobot(TruePose start, std::uint64_t seed = 1,
                           const ObserverNoise& errors = {});

  // Believes to stand there when it starts; without, it has to find out.
  void believe(const Pose2& pose, double positionSd, Angle headingSd);
  // Steps the localiser: one frame.
  WorldModel step();

  double error(const WorldModel& world) const;         // cm
  double headingError(const WorldModel& world) const;  // deg

  gps::GpsParams params;
  gps::GpsState state;
  decltype(&gps::step) localise = gps::step;  // or another in its place
};

// Stands at a random place and turns its head from side to side and back in four seconds. Errors of
// the camera's pose stay while it stands.
class StandingRobot : public LocalisingRobot {
 public:
  // The same seed gives the same place, errors and start.
  explicit StandingRobot(std::uint64_t seed);

  // Believes to stand within 40 cm and 20 deg of where it does.
  void believeCoarsely();
  // Sees one frame of its pan; landmarks too if asked for.
  void look(bool landmarks);

  Pose2 twin() const;  // after half a turn of the field
};

// A belief beside a pose.
struct BeliefError {
  double cm = 0.0;
  double deg = 0.0;
  bool within(double maxCm, double maxDeg) const { return cm <= maxCm && deg <= maxDeg; }
};
BeliefError beliefError(const Pose2& believed, const Pose2& truth);

}  // namespace kelpie::sim
