// SPDX-License-Identifier: Apache-2.0
// A body that follows its joint targets at once: drives the actuator message by message and keeps
// what each tick commanded.
#pragma once

#include <vector>

#include "actuator/Actuator.h"
#include "robot/body/Legs.h"

namespace kelpie::actuator {

// Parameters whose walks do exactly what is asked, so that facts of the geometry can be checked.
inline ActuatorParams exactWalks() {
  ActuatorParams params;
  params.walks = {};
  params.walks.normal.gait.lead = 1.0;
  params.walks.normal.stance.hindLateral = 9.5;
  return params;
}

class Walker {
 public:
  explicit Walker(const ActuatorParams& parameters = exactWalks()) : params(parameters) {}

  // Runs the command for some messages of four ticks.
  void run(const Command& command, int messages) {
    input.command = command;
    for (int i = 0; i < messages; ++i) {
      out = step(input, params, state);
      for (const JointFrame& frame : out.joints) ticks.push_back(frame.target);
      for (SensorFrame& sensors : input.sensors) sensors.joints = out.joints.back().target;
      travelled.push_back(out.odometry);
    }
  }
  void run(const WalkRequest& walk, int messages) {
    Command command;
    command.walk = walk;
    run(command, messages);
  }
  void standUp() {
    run(Command{}, 80);
    ticks.clear();
    travelled.clear();
  }
  // Where the commanded joints put a foot when the body is carried as the walk says.
  Point3<Robot> foot(const JointAngles& joints, LegId leg) const {
    const Stance carried{stance().shoulderHeight, stance().bodyTilt, {}};
    return body::robotFromTorso(carried, body::footPosition(leg, body::legAngles(joints, leg)));
  }
  // The stance of a robot whose legs stand as the walk says: it rests on round paws and cowls.
  Stance stood() const {
    JointAngles joints;
    setLegs(params.walks.normal, {}, {}, joints);
    return body::stanceFromLegs(joints);
  }
  const StanceParams& stance() const { return params.walks.normal.stance; }

  ActuatorParams params;
  ActuatorState state;
  MotionInput input;
  MotionOutput out;
  std::vector<JointAngles> ticks;
  std::vector<Odometry> travelled;
};

constexpr std::array<LegId, 4> kLegs = {LegId::leftFront, LegId::leftHind, LegId::rightFront,
                                        LegId::rightHind};

}  // namespace kelpie::actuator
