// SPDX-License-Identifier: Apache-2.0
// gps: odometry and Percepts become the WorldModel, by an extended Kalman filter with several modes
// (thesis 2004 chapter 2) and a ball filter.
#pragma once

#include "gps/GpsIn.h"
#include "gps/GpsParams.h"
#include "gps/GpsState.h"
#include "gps/PoseSteps.h"
#include "robot/core/types/WorldModel.h"

namespace kelpie::gps {

// Builds what follows from the field alone: 20 M instructions, more than a frame has on the robot.
// A step does it for a state that was not prepared.
void prepare(const GpsParams& params, GpsState& state);

// Writes over what `world` held.
void stepInto(WorldModel& world, const GpsIn& in, const GpsParams& params, GpsState& state);

WorldModel step(const GpsIn& in, const GpsParams& params, GpsState& state);

// A step whose landmarks correct the modes in a way of their own.
WorldModel stepWith(LandmarkUpdate update, const GpsIn& in, const GpsParams& params,
                    GpsState& state);

// The last part of a step, after the pose: ball, players, and what is published.
WorldModel believe(const GpsIn& in, const Step& moved, const GpsParams& params, GpsState& state);

}  // namespace kelpie::gps
