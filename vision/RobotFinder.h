// SPDX-License-Identifier: Apache-2.0
// Other robots: red and dark blue uniform patches that stand on the carpet, those of one robot put
// together. Distance from where the nearest leg meets the carpet, heading by the middle of the
// patches. A robot seen straight from the front or back shows hardly any patch and is missed.
#pragma once

#include "robot/core/Percepts.h"
#include "vision/Foot.h"
#include "vision/RobotParams.h"
#include "vision/Scene.h"

namespace kelpie::vision {

struct RobotPatch {
  TeamColour team = TeamColour::red;
  double samples = 0.0;
  PixelBox box;
  PixelPoint centre;
  Foot foot;              // the nearest of the columns below and beside the patch
  double distance = 0.0;  // cm along the ground from the camera to the nearest leg
  double scale = 1.0;     // px per cm there
  double height = 0.0;    // cm of the centre above the ground
  double shell = 0.0;     // share of white and grey round it
};

// The checks, each alone: true = keep.
bool robotPatchIsLarge(const RobotPatch& patch, const RobotParams& p);
bool robotPatchIsLow(const Scene& scene, const RobotPatch& patch, const RobotParams& p);
bool robotPatchHasSize(const RobotPatch& patch, const RobotParams& p);
bool robotHasShell(const RobotPatch& patch, const RobotParams& p);
bool robotIsInsideFieldEdge(const Scene& scene, const RobotPatch& patch, const RobotParams& p);
bool robotStandsOnGround(const RobotPatch& patch, const RobotParams& p);
bool robotIsNear(const RobotPatch& patch, const RobotParams& p);
// Whether two patches can be of one robot.
bool areOfOneRobot(const RobotPatch& a, const RobotPatch& b, const RobotParams& p);

using Robots = FixedVector<RobotPercept, 8>;
void findRobots(const Scene& scene, const RobotParams& params, VisionCounts& counts,
                Robots& robots);

}  // namespace kelpie::vision
