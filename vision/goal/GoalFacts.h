// SPDX-License-Identifier: Apache-2.0
// Whether what passed every check is a goal: plain facts of the candidate. Clothes and boxes behind
// the carpet pass each single check now and then, but seldom all of them well. Weak where only a
// few columns of a goal show: then either error is likely.
#pragma once

#include "vision/goal/GoalCandidate.h"
#include "vision/goal/GoalShape.h"

namespace kelpie::vision {

struct GoalFacts {
  double wallDistance = 0.0;   // cm, camera to the wall
  double visibleWidth = 0.0;   // cm of the mouth's line between the ends
  double width = 0.0;          // px
  double lowestFoot = 0.0;     // px below the field edge, of the lowest foot
  double meanFoot = 0.0;       // px below it, mean of the chosen columns' feet
  double footError = 0.0;      // deg, of the middle column, as in settled play (ElevationDoubt.h)
  double misfit = 0.0;         // cost of the fitted shape for each measured column
  double measured = 0.0;       // columns whose height tells their distance
  double chosen = 0.0;         // columns of the goal
  double coloured = 0.0;       // area of its samples to that of the box of its columns
  double paint = 1.0;          // GoalColour.h, mean of its columns
  double green = 0.0;          // share of all columns with carpet below
  double hidden = 0.0;         // ends before which a robot stands
  double cut = 0.0;            // ends that an image border cuts
  double topCut = 0.0;         // 1: the image cuts a column's top
  double lateralOffset = 0.0;  // cm of the camera from the goal's axis
  // Its place on the field (GoalPlace.h); 0 where nothing in the image tells.
  double edgeDistance = 0.0;  // cm from the back wall to the field edge below it
  double edgeTurn = 0.0;      // deg between that and the mouth
  // cm of the camera from the goal's axis, which is square to the edge
  double edgeLateralOffset = 0.0;
  double cornerError = 0.0;  // cm by which another edge is not half a carpet from the goal's middle
  double beaconError = 0.0;  // cm by which the goal is too near to a beacon or too far from it
  double offCarpetDistance = 0.0;  // cm of the camera off the carpet, as goal and beacon place it

  template <int = 0>
  static constexpr auto fields() {
    using Facts = GoalFacts;
    return fieldList(
        field("wallDistance", &Facts::wallDistance), field("visibleWidth", &Facts::visibleWidth),
        field("width", &Facts::width), field("lowestFoot", &Facts::lowestFoot),
        field("meanFoot", &Facts::meanFoot), field("footError", &Facts::footError),
        field("misfit", &Facts::misfit), field("measured", &Facts::measured),
        field("chosen", &Facts::chosen), field("coloured", &Facts::coloured),
        field("paint", &Facts::paint), field("green", &Facts::green),
        field("hidden", &Facts::hidden), field("cut", &Facts::cut), field("topCut", &Facts::topCut),
        field("lateralOffset", &Facts::lateralOffset), field("edgeDistance", &Facts::edgeDistance),
        field("edgeTurn", &Facts::edgeTurn), field("edgeLateralOffset", &Facts::edgeLateralOffset),
        field("cornerError", &Facts::cornerError), field("beaconError", &Facts::beaconError),
        field("offCarpetDistance", &Facts::offCarpetDistance));
  }
};

// All but its place on the field.
GoalFacts goalFacts(const Scene& scene, const GoalCandidate& c, const GoalShape& shape);

}  // namespace kelpie::vision
