// SPDX-License-Identifier: Apache-2.0
// Vision's memory: the calibration as tables, made for a light, and work buffers that
// each step overwrites. Nothing else of an earlier image is seen again. 500 KB: keep it off the
// stack.
#pragma once

#include "vision/ball/JudgedBall.h"
#include "vision/beacon/JudgedBeacon.h"
#include "vision/blobs/Blobs.h"
#include "vision/colour/VisionCalibration.h"
#include "vision/goal/JudgedGoal.h"
#include "vision/pixels/Sampler.h"
#include "vision/robot/JudgedRobot.h"

namespace kelpie::vision {

struct VisionState {
  VisionState() : VisionState(nominalCalibration()) {}
  explicit VisionState(const VisionCalibration& calibration) : tables(calibration) {}

  PixelTables tables;
  ClassMemory classes;
  RunBuffer runs;
  BlobBuffer blobs;
  JudgedBalls judgedBalls;
  JudgedBeacons judgedBeacons;
  JudgedGoals judgedGoals;
  JudgedRobots judgedRobots;
};

}  // namespace kelpie::vision
