// SPDX-License-Identifier: Apache-2.0
// Goals: the one that fits best among the large blue and yellow blobs, alone and with their
// neighbours. Distance from the angle that the goal's 30 cm of height fill in several columns, or
// from where its foot meets the ground when the top is cut (GoalColumns); its three walls are laid
// through these (GoalShape), and the percept is the middle of the mouth. Weak when a post is
// outside the image or behind a robot.
#pragma once

#include "robot/core/types/Percepts.h"
#include "vision/Scene.h"
#include "vision/goal/GoalCandidate.h"
#include "vision/goal/GoalFinderParams.h"
#include "vision/goal/GoalGaps.h"
#include "vision/goal/JudgedGoal.h"

namespace kelpie::vision {

// The checks: true = keep.
bool goalIsLarge(const GoalCandidate& c, const GoalFinderParams& p);
bool goalHasShape(const GoalCandidate& c, const GoalFinderParams& p);
bool goalStandsBelowHorizon(const Scene& scene, const GoalCandidate& c, const GoalFinderParams& p);
bool goalStandsInsideFieldEdge(const Scene& scene, const GoalCandidate& c,
                               const GoalFinderParams& p);
bool goalHasFieldBelow(const GoalCandidate& c, const GoalFinderParams& p);
bool goalHasNoPinkBeside(const Scene& scene, const GoalCandidate& c);
bool goalIsMeasured(const GoalCandidate& c);
bool goalHasWidth(const Scene& scene, const GoalCandidate& c, const GoalFinderParams& p);
// Whether it may be the part of a goal that something else leaves.
bool goalIsPart(const Scene& scene, const GoalCandidate& c, const GoalFinderParams& p);
bool goalIsNear(const GoalCandidate& c, const GoalFinderParams& p);

// Call after findBeacons: `landmarks` holds the beacons found, whose bands are left out.
void findGoals(const Scene& scene, const GoalFinderParams& params, VisionCounts& counts,
               Landmarks& landmarks, GoalGaps& gaps, JudgedGoals& judged);

}  // namespace kelpie::vision
