// SPDX-License-Identifier: Apache-2.0
// A sighting that no pose near the robot's predicts.
#pragma once

#include "tools/sim/world/LocalisingRobot.h"

namespace kelpie::gps {

// A beacon 120 deg beside where it should be.
inline void seeFalsely(sim::LocalisingRobot& robot) {
  const auto landmarks = body::landmarksFor(robot.params.field, robot.input.game.team);
  LandmarkPercept p = robot.look(landmarks[3], false);
  p.heading = p.heading + Angle::deg(120);
  robot.percepts.landmarks.push_back(p);
  robot.walk(0, 0, 0);
  robot.step();
  robot.percepts.landmarks.clear();
}

}  // namespace kelpie::gps
