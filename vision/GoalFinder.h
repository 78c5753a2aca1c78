// SPDX-License-Identifier: Apache-2.0
// Goals: the one that fits best among the large blue and yellow blobs, alone and with their
// neighbours. Distance from the angle that the goal's 30 cm of height fill in several columns, or
// from where its foot meets the ground when the top is cut (GoalColumns); its three walls are laid
// through these (GoalShape), and the percept is the middle of the mouth. Weak when a post is
// outside the image or behind a robot.
#pragma once

#include "robot/core/Percepts.h"
#include "vision/BeaconFinder.h"
#include "vision/Scene.h"
#include "vision/VisionParams.h"

namespace kelpie::vision {

// One upright cut through the coloured wall.
struct GoalColumn {
  double u = 0.0;
  PixelPoint top;
  PixelPoint foot;
  bool topCut = false;  // the image ends before the wall does
  bool footCut = false;
  bool green = false;      // carpet right below the foot
  bool tall = false;       // far more than 30 cm at the distance of its foot
  bool chosen = false;     // of the goal, not of something behind or beside it
  double distance = 0.0;   // cm on the ground, camera to the wall, 0 = not measured
  double sd = 0.0;         // cm
  double footError = 0.0;  // rad, elevation of the foot less that of the ground there
};
constexpr std::size_t kGoalColumns = 24;

struct GoalEnd {
  PixelPoint point;
  bool cut = false;     // the image ends before the goal does
  bool hidden = false;  // a robot stands before it
  bool open() const { return cut || hidden; }
};

struct GoalCandidate {
  ColourClass colour = ColourClass::none;
  std::uint32_t samples = 0;
  LevelBox box;
  FixedVector<GoalColumn, kGoalColumns> columns;
  GoalEnd left;
  GoalEnd right;
  bool topCut = false;
  bool bottomCut = false;
  double wallDistance = 0.0;  // cm on the ground, camera to the middle of what is seen, 0 = unknown
  double distanceSd = 0.0;    // cm
  double footError = 0.0;     // rad, of the middle column
};

LandmarkKind goalKind(ColourClass colour);

// How much of the mouth's line is seen, in cm, between two ends at the mouth's distance.
double visibleWidth(const Scene& scene, const GoalCandidate& c, const GoalFinderParams& p);

// How far the feet of the chosen columns are below the field edge, in px.
struct GoalFeet {
  double lowest = -1e9;
  double sum = 0.0;
  int count = 0;
};
GoalFeet feetOf(const Scene& scene, const GoalCandidate& c);

struct ColumnCounts {
  int chosen = 0;
  int measured = 0;  // of these, columns whose height tells their distance
};
ColumnCounts countColumns(const GoalCandidate& c);

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

struct JudgedGoal;
using JudgedGoals = FixedVector<JudgedGoal, 16>;
using GoalGaps = FixedVector<GoalGap, 6>;

// Call after findBeacons: `landmarks` holds the beacons found, whose bands are left out.
void findGoals(const Scene& scene, const GoalFinderParams& params, VisionCounts& counts,
               Landmarks& landmarks, GoalGaps& gaps, JudgedGoals& judged);

}  // namespace kelpie::vision
