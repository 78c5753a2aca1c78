// SPDX-License-Identifier: Apache-2.0
// How the ball's state in the robot frame changes when the robot moves and the ball rolls.
#pragma once

#include "gps/ball/BallFilterParams.h"
#include "gps/ball/BallState.h"
#include "gps/pose/Predict.h"

namespace kelpie::gps {

// Where a resting point of the ground is seen after the step.
Point2<Robot> seenAfter(Point2<Robot> point, const Odometry& odometry);

void moveRobot(BallHypothesis& ball, const Odometry& odometry, const StepNoise& noise);

// Rolls on for `elapsed` seconds, slowed by the carpet: dv/dt = -(drag v + deceleration).
void roll(BallHypothesis& ball, double elapsed, const BallFilterParams& params);

// How far a ball of this speed (cm/s) rolls until it lies: the integral of v dv / (drag v +
// deceleration) from 0 to the speed, in cm.
double rollingDistance(double speed, const BallFilterParams& params);

}  // namespace kelpie::gps
