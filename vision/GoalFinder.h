// SPDX-License-Identifier: Apache-2.0
// Goals: of the large blue and yellow blobs, alone and with their neighbours, the one that fits
// best. Distance from the angle that the goal's 30 cm of height fill in several columns, or from
// where its foot meets the ground when the top is cut. What is measured is the back wall; the
// percept is the middle of the mouth, a goal's depth nearer. Weak when one post is outside the
// image.
#pragma once

#include "robot/core/Percepts.h"
#include "vision/BeaconFinder.h"
#include "vision/Scene.h"
#include "vision/VisionParams.h"

namespace kelpie::vision {

struct GoalCandidate {
  ColourClass colour = ColourClass::none;
  std::uint32_t samples = 0;
  PixelBox box;
  PixelPoint leftEdge;
  PixelPoint rightEdge;
  bool leftCut = false;  // the image ends before the goal does
  bool rightCut = false;
  bool topCut = false;
  bool bottomCut = false;
  double distance = 0.0;    // cm on the ground from the camera to the mouth, 0 = not measured
  double distanceSd = 0.0;  // cm
  int columns = 0;          // in which it was measured
  int fieldColumns = 0;     // of these, with green right below
  int tallColumns = 0;      // of these, reaching the image's top at more than 30 cm
  double footError = 0.0;   // rad, elevation of the foot less that of the ground there
};

// The checks: true = keep.
bool goalIsLarge(const GoalCandidate& c, const GoalParams& p);
bool goalHasShape(const GoalCandidate& c, const GoalParams& p);
bool goalStandsBelowHorizon(const Scene& scene, const GoalCandidate& c, const GoalParams& p);
bool goalStandsInsideFieldEdge(const Scene& scene, const GoalCandidate& c, const GoalParams& p);
bool goalHasFieldBelow(const GoalCandidate& c, const GoalParams& p);
bool goalHasNoPinkBeside(const Scene& scene, const GoalCandidate& c);
bool goalIsMeasured(const GoalCandidate& c);
bool goalHasWidth(const Scene& scene, const GoalCandidate& c, const GoalParams& p);
bool goalStandsOnGround(const GoalCandidate& c, const GoalParams& p);
bool goalIsNear(const GoalCandidate& c, const GoalParams& p);

// Call after findBeacons: `landmarks` holds the beacons found, whose bands are left out.
void findGoals(const Scene& scene, const GoalParams& params, VisionCounts& counts,
               Landmarks& landmarks);

}  // namespace kelpie::vision
