// SPDX-License-Identifier: Apache-2.0
// One patch of a robot's uniform, measured along the horizon and square to it (the head rolls the
// image by up to 90 deg), and the checks that tell it from clothes, things and the ball's
// shade. Where its robot stands is the nearest point at which a column below it meets the carpet.
#pragma once

#include "robot/core/types/Percepts.h"
#include "vision/Foot.h"
#include "vision/Scene.h"
#include "vision/pixels/Extent.h"
#include "vision/robot/RobotFacts.h"
#include "vision/robot/RobotFinderParams.h"

namespace kelpie::vision {

struct RobotPatch {
  TeamColour team = TeamColour::red;
  double samples = 0.0;
  LevelBox levelBox;
  PixelBox box;  // around it in the image
  PixelPoint centre;
  Extent extent;
  Foot foot;                          // the nearest of the columns below and beside the patch
  double distance = 0.0;              // cm along the ground from the camera to the nearest leg
  double scale = 1.0;                 // px per cm there
  double height = 0.0;                // cm of the centre above the ground
  double distanceSd = 0.0;            // cm of it that a badly known tilt alone makes
  double heightSd = 0.0;              // cm, the same
  double carpetBehind = 0.0;          // px of carpet beyond the foot, beside the robot
  double carpetBeyond = kNoDistance;  // cm along the ground from the foot to the field edge
  double shellShare = 0.0;            // share of white and grey round the patch
  double foreignShare = 0.0;          // share on the same ring of colours that no robot wears
  double ownShare = 0.0;              // share of its colour among all the colours inside its box
  bool meanIsOwn = false;             // its mean colour is the uniform's
};

// What is cheap to know of a blob in a uniform's colour.
RobotPatch patchOf(const Scene& scene, const Blob& blob);
// Extent, foot and distance.
void measurePatch(const Scene& scene, const RobotFinderParams& p, RobotPatch& patch);
// What is round the patch and behind the foot.
void measureSurroundings(const Scene& scene, RobotPatch& patch);

// After both: what tells whether it is a robot's.
RobotFacts robotFacts(const Scene& scene, const RobotPatch& patch);

// The checks, each alone: true = keep.
bool robotPatchIsLow(const Scene& scene, const RobotPatch& patch, const RobotFinderParams& p);
bool robotPatchHasColour(const RobotPatch& patch, const RobotFinderParams& p);
bool robotPatchHasSize(const RobotPatch& patch, const RobotFinderParams& p);
bool robotPatchIsSolid(const RobotPatch& patch);
bool robotPatchIsPure(const RobotPatch& patch, const RobotFinderParams& p);
// Hardly another colour in or near it: believed even where no carpet behind it is in the image.
bool robotPatchIsClean(const RobotPatch& patch, const RobotFinderParams& p);
// Large and of one colour: part of a robot, if one stands there at all.
bool robotPatchTellsDistance(const RobotPatch& patch, const RobotFinderParams& p);
bool robotHasShell(const RobotPatch& patch, const RobotFinderParams& p);
bool robotIsNoSpeck(const RobotPatch& patch, const RobotFinderParams& p);
bool robotFeetMayBeCut(const RobotPatch& patch, const RobotFinderParams& p);
bool robotIsInsideFieldEdge(const Scene& scene, const RobotPatch& patch,
                            const RobotFinderParams& p);
bool robotStandsOnGround(const RobotPatch& patch, const RobotFinderParams& p);
bool robotIsNear(const RobotPatch& patch, const RobotFinderParams& p);

}  // namespace kelpie::vision
