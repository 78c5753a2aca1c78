// SPDX-License-Identifier: Apache-2.0
// Vision's memory: the calibration and work buffers that each step overwrites. Nothing of an
// earlier image survives. 300 KB: keep it off the stack.
#pragma once

#include "vision/ball/JudgedBall.h"
#include "vision/beacon/JudgedBeacon.h"
#include "vision/blobs/Blobs.h"
#include "vision/goal/JudgedGoal.h"
#include "vision/pixels/RingTable.h"
#include "vision/pixels/Sampler.h"
#include "vision/pixels/VisionCalibration.h"
#include "vision/robot/JudgedRobot.h"

namespace kelpie::vision {

struct VisionState {
  VisionState() : VisionState(nominalCalibration()) {}
  explicit VisionState(const VisionCalibration& given) : calibration(given) {}

  VisionCalibration calibration;
  RingDistances distances;
  ClassPlane classes{};
  RunBuffer runs;
  BlobBuffer blobs;
  JudgedBalls judgedBalls;
  JudgedBeacons judgedBeacons;
  JudgedGoals judgedGoals;
  JudgedRobots judgedRobots;
};

}  // namespace kelpie::vision
