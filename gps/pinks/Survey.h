// SPDX-License-Identifier: Apache-2.0
// What a robot that does not know its place has seen around it: line points, one a cell, and
// directions of pink, in the robot frame of where it began, carried along by odometry. Meant for a
// robot that stands or turns on the spot: what it walks adds the odometry's error.
#pragma once

#include "gps/lines/LineFit.h"
#include "gps/pinks/PinkBearing.h"
#include "gps/pinks/PinkMapParams.h"
#include "gps/pinks/PinkState.h"
#include "robot/core/types/FrameInput.h"
#include "robot/core/types/Percepts.h"

namespace kelpie::gps {

// The robot moved for a frame.
void moveSurvey(const Odometry& odometry, double elapsed, Survey& survey);

// What it sees now. Line points that are not finite are left out.
void addToSurvey(const FixedVector<LinePoint, 256>& points, const PinkBearings& bearings,
                 const PinkPoseSearchParams& params, Survey& survey);

// The line points, thinned to at most `max` of them.
SeenLines linesOf(const Survey& survey, std::size_t max);

// The pose of the robot now, when its survey began at `start`.
Pose2 poseNow(const Survey& survey, const Pose2& start);

}  // namespace kelpie::gps
