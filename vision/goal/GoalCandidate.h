// SPDX-License-Identifier: Apache-2.0
// What may be a goal: upright columns of its colour, its ends, and what is cut or hidden.
// GoalFinder makes one of each blob or group of blobs, GoalColumns measures it.
#pragma once

#include "robot/core/ScratchVector.h"
#include "robot/core/types/Percepts.h"
#include "vision/ElevationDoubt.h"
#include "vision/Scene.h"
#include "vision/goal/GoalFinderParams.h"

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
  double paint = 1.0;      // GoalColour.h, mean of three places
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
  ScratchVector<GoalColumn, kGoalColumns> columns;
  GoalEnd left;
  GoalEnd right;
  bool topCut = false;
  bool bottomCut = false;
  double wallDistance = 0.0;  // cm on the ground, camera to the middle of what is seen, 0 = unknown
  double distanceSd = 0.0;    // cm
  double footError = 0.0;     // rad, of the middle column
  ElevationDoubt doubt;       // of elevations there

  // The middle column's as it would count in settled play.
  double settledFootError() const { return footError / doubt.spread; }
};

LandmarkKind goalKind(ColourClass colour);

// How much of the mouth's line is seen, in cm, between two ends at the mouth's distance.
double visibleWidth(const Scene& scene, const GoalCandidate& c);

// How far the feet of the chosen columns are below the field edge, in px.
struct GoalFeet {
  double lowest = -kFarOutside;  // without any
  double sum = 0.0;
  int count = 0;
};
GoalFeet feetOf(const Scene& scene, const GoalCandidate& c);

struct ColumnCounts {
  int chosen = 0;
  int measured = 0;  // of these, columns whose height tells their distance
};
ColumnCounts countColumns(const GoalCandidate& c);

}  // namespace kelpie::vision
