// SPDX-License-Identifier: Apache-2.0
// Other robots: red and dark blue uniform patches that stand on the carpet, those of one robot put
// together. Distance from where the nearest leg meets the carpet, heading by the middle of the
// patches. A robot seen straight from the front or back shows hardly any patch and is missed.
#pragma once

#include "robot/core/types/Percepts.h"
#include "vision/robot/JudgedRobot.h"
#include "vision/robot/RobotFacts.h"
#include "vision/robot/RobotPatch.h"

namespace kelpie::vision {

// Patches of one robot: their extent along the horizon (HorizonFrame::along).
struct PatchGroup {
  TeamColour team = TeamColour::red;
  double samples = 0.0;
  double left = 0.0;
  double right = 0.0;
  PixelPoint centre;  // of the largest patch
  PixelBox box;
  bool cut = false;       // the feet are not in the image
  double distance = 0.0;  // cm along the ground from the camera to the nearest leg
  double scale = 1.0;     // px per cm there
  RobotFacts facts;       // of the largest patch, and the number of patches
};

// The group of one patch, without its facts.
PatchGroup groupOf(const RobotPatch& patch, const HorizonFrame& frame);
// Whether two groups can be of one robot.
bool areOfOneRobot(const PatchGroup& a, const PatchGroup& b, const RobotFinderParams& p);
PatchGroup joined(const PatchGroup& larger, const PatchGroup& other);
// A head's legs are hidden by its own trunk, so that carpet behind it is taken for where it stands.
// The trunk's patch may be too dubious to be a robot by itself, but it tells how near that one is.
PatchGroup nearer(const PatchGroup& group, const PatchGroup& part);

constexpr std::size_t kMaxRobotPercepts = 8;
using Robots = FixedVector<RobotPercept, kMaxRobotPercepts>;
void findRobots(const Scene& scene, const RobotFinderParams& params, VisionCounts& counts,
                Robots& robots, JudgedRobots& judged);

}  // namespace kelpie::vision
