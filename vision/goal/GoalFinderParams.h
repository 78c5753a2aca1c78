// SPDX-License-Identifier: Apache-2.0
// Tunables of the search for goals, 80 cm wide and 30 cm high and deep.
#pragma once

#include "robot/core/Angle.h"
#include "robot/core/fields/Fields.h"

namespace kelpie::vision {

struct GoalFinderParams {
  double minSamples = 20;                  // lattice samples
  double minWidth = 8;                     // px
  double minHeight = 5;                    // px
  double maxTall = 3;                      // height to width of a goal that no image border cuts
  double maxFlat = 8;                      // width to height; 80 : 30 seen from the front is 2.7
  double maxAboveHorizon = 12;             // px, of the lower edge: facts-2005 4.5 check 7 has 20
  double maxAboveFieldEdge = 1.6;          // px, of the lowest foot
  double maxMeanAboveFieldEdge = 5;        // px, of all feet
  double minFieldColumns = 0.1;            // share of columns with green below, check 8
  double minVisibleWidth = 18;             // cm between the ends, seen 60 deg from the side: 66
  double minCutWidth = 15;                 // cm of a goal that the image border cuts
  double minHiddenWidth = 12;              // cm between two robots that hide both posts
  double maxVisibleWidth = 170;            // cm, with a side wall seen from outside
  Angle directionError = Angle::deg(2.2);  // a column's foot against the ground at its distance
  double maxPartWidth = 65;  // cm of a goal that would be turned away if its ends were posts
  double minPartBelowFieldEdge =
      -0.1;  // px, of such a part's lowest foot: a box beyond it has less
  double maxPartMeanAboveFieldEdge = 0.8;  // px, of all its feet
  Angle partDirection = Angle::deg(0.3);   // of its feet against the ground
  double maxLogOddsAgainst = -0.3;         // log odds, see GoalFacts.h
  double maxDistance = 560;           // the opposite goal's back wall, seen from the own mouth: 570
  Angle maxTurn = Angle::deg(80);     // of the mouth from square to the line of sight
  double maxLateralOffset = 450;      // cm from the goal's axis: half the field, and a turn's error
  double edgeSd = 0.5;                // px, of the upper and of the lower edge
  double edgeBias = 0.0;              // px of this camera, by which a height is measured too large
  Angle directionSd = Angle::deg(1);  // camera against ground, while walking
  Angle headingSd = Angle::deg(1);

  template <int = 0>
  static constexpr auto fields() {
    return fieldList(
        field("minSamples", &GoalFinderParams::minSamples, "", 1, 1000),
        field("minWidth", &GoalFinderParams::minWidth, "px", 1, 100),
        field("minHeight", &GoalFinderParams::minHeight, "px", 1, 100),
        field("maxTall", &GoalFinderParams::maxTall, "", 0.1, 10),
        field("maxFlat", &GoalFinderParams::maxFlat, "", 1, 50),
        field("maxAboveHorizon", &GoalFinderParams::maxAboveHorizon, "px", -160, 160),
        field("maxAboveFieldEdge", &GoalFinderParams::maxAboveFieldEdge, "px", -160, 160),
        field("maxMeanAboveFieldEdge", &GoalFinderParams::maxMeanAboveFieldEdge, "px", -160, 160),
        field("minFieldColumns", &GoalFinderParams::minFieldColumns, "", 0, 1),
        field("minVisibleWidth", &GoalFinderParams::minVisibleWidth, "cm", 0, 200),
        field("minCutWidth", &GoalFinderParams::minCutWidth, "cm", 0, 200),
        field("minHiddenWidth", &GoalFinderParams::minHiddenWidth, "cm", 0, 200),
        field("maxVisibleWidth", &GoalFinderParams::maxVisibleWidth, "cm", 0, 500),
        field("directionError", &GoalFinderParams::directionError, "rad", 0, 20),
        field("maxPartWidth", &GoalFinderParams::maxPartWidth, "cm", 0, 200),
        field("minPartBelowFieldEdge", &GoalFinderParams::minPartBelowFieldEdge, "px", -160, 160),
        field("maxPartMeanAboveFieldEdge", &GoalFinderParams::maxPartMeanAboveFieldEdge, "px", -160,
              160),
        field("partDirection", &GoalFinderParams::partDirection, "rad", 0, 20),
        field("maxLogOddsAgainst", &GoalFinderParams::maxLogOddsAgainst, "", -20, 20),
        field("maxDistance", &GoalFinderParams::maxDistance, "cm", 50, 1000),
        field("maxTurn", &GoalFinderParams::maxTurn, "rad", 0, 90),
        field("maxLateralOffset", &GoalFinderParams::maxLateralOffset, "cm", 0, 2000),
        field("edgeSd", &GoalFinderParams::edgeSd, "px", 0.01, 5),
        field("edgeBias", &GoalFinderParams::edgeBias, "px", -5, 5),
        field("directionSd", &GoalFinderParams::directionSd, "rad", 0.05, 20),
        field("headingSd", &GoalFinderParams::headingSd, "rad", 0.01, 20));
  }
};

}  // namespace kelpie::vision
