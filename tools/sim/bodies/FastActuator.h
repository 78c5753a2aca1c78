// SPDX-License-Identifier: Apache-2.0
// What an agent must know of a kinematic body, whose feet carry it without slip or sway: odometry
// is estimated from the joints alone, and motions take it nowhere. Its walks are those of physical
// bodies.
#pragma once

#include "actuator/ActuatorParams.h"
#include "tools/sim/bodies/RobotModel.h"

namespace kelpie::sim {

inline void makeFast(const RobotParams& robot, actuator::ActuatorParams& params) {
  const auto odometryOf = [&robot](double forward, double left, double turn) {
    actuator::WalkOdometry odometry;
    odometry.forward.joints = forward * robot.ground.forward;
    odometry.left.joints = left * robot.ground.left;
    odometry.turn.joints = turn * robot.ground.turn;
    return odometry;
  };
  for (std::uint8_t kind = 0; kind < kWalkKindCount; ++kind)
    actuator::walkSet(params.walks, static_cast<WalkKind>(kind)).odometry =
        odometryOf(1.0, 1.0, 1.0);
  params.walks.weak.odometry = odometryOf(robot.weak.forward, robot.weak.left, robot.weak.turn);
  for (actuator::MotionData& motion : params.motions.of) motion.way = {};
  // Its legs push nothing and its accelerometer knows of no weight: loads mean nothing.
  params.feeling.stuckLoad = 1.0;
  // Its fast walk's paws graze the carpet in the air, and it cannot be blocked: legs pass through.
  params.feeling.blockedSeconds = 0.0;
  params.physical = false;
}

}  // namespace kelpie::sim
