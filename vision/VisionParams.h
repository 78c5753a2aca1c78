// SPDX-License-Identifier: Apache-2.0
// Vision's tunables by object. Where a number is not explained here, README.md gives its source.
#pragma once

#include <cstdint>

#include "robot/core/Angle.h"
#include "robot/core/Fields.h"
#include "vision/ObstacleParams.h"
#include "vision/PinkParams.h"
#include "vision/RobotParams.h"

namespace kelpie::vision {

struct BallParams {
  double minSamples = 2;         // lattice samples of orange
  double minEdgePoints = 5;      // of 16 spokes
  double maxCircleError = 0.15;  // rms of the edge points, in radii, plus 0.3 px
  double minOrangeShare = 0.5;   // of the circle
  double maxOtherShare = 0.35;   // of pink, yellow and robot red together, of the circle
  double maxAboveHorizon = 10;   // facts-2005 4.5 check 1
  double maxAboveFieldEdge = 4;  // of the ball's lowest point
  double minFieldPoints = 2;     // green or lower image border among 7 points beside and below
  double maxDistance = 450;      // 2006 field: 420 is the far corner seen from the middle
  Angle directionError = Angle::deg(3);  // camera against ground, for ballOffGround
  Angle directionSd = Angle::deg(1);     // the same as a standard deviation, while walking
  double edgeSd = 0.3;                   // px, of the radius
  Angle headingSd = Angle::deg(0.7);

  static constexpr auto fields() {
    return fieldList(field("minSamples", &BallParams::minSamples, "", 1, 100),
                     field("minEdgePoints", &BallParams::minEdgePoints, "", 4, 16),
                     field("maxCircleError", &BallParams::maxCircleError, "", 0, 1),
                     field("minOrangeShare", &BallParams::minOrangeShare, "", 0, 1),
                     field("maxOtherShare", &BallParams::maxOtherShare, "", 0, 1),
                     field("maxAboveHorizon", &BallParams::maxAboveHorizon, "px", -160, 160),
                     field("maxAboveFieldEdge", &BallParams::maxAboveFieldEdge, "px", -160, 160),
                     field("minFieldPoints", &BallParams::minFieldPoints, "", 0, 7),
                     field("maxDistance", &BallParams::maxDistance, "cm", 50, 1000),
                     field("directionError", &BallParams::directionError, "rad", 0, 20),
                     field("directionSd", &BallParams::directionSd, "rad", 0.05, 20),
                     field("edgeSd", &BallParams::edgeSd, "px", 0.01, 5),
                     field("headingSd", &BallParams::headingSd, "rad", 0.01, 20));
  }
};

struct BeaconParams {
  double minSamples = 2;   // lattice samples of pink
  double minBand = 2.5;    // px, each coloured band
  double maxRatio = 2.0;   // of the two bands' heights
  double maxAspect = 2.2;  // width to height of the pink band, and its inverse
  double minWidth = 5;     // cm at the measured distance; the rule is 10
  double maxWidth = 16;
  double maxBelowHorizon = 25;  // px, facts-2005 4.5 check 5
  double minWhiteProbes = 1;    // of three below the coloured part
  Angle elevationError = Angle::deg(6);
  double maxDistance = 620;  // the field's diagonal
  double edgeSd = 0.35;      // px, of each band edge
  Angle headingSd = Angle::deg(0.7);

  static constexpr auto fields() {
    return fieldList(field("minSamples", &BeaconParams::minSamples, "", 1, 100),
                     field("minBand", &BeaconParams::minBand, "px", 1, 50),
                     field("maxRatio", &BeaconParams::maxRatio, "", 1, 10),
                     field("maxAspect", &BeaconParams::maxAspect, "", 1, 10),
                     field("minWidth", &BeaconParams::minWidth, "cm", 0, 50),
                     field("maxWidth", &BeaconParams::maxWidth, "cm", 0, 50),
                     field("maxBelowHorizon", &BeaconParams::maxBelowHorizon, "px", -160, 160),
                     field("minWhiteProbes", &BeaconParams::minWhiteProbes, "", 0, 3),
                     field("elevationError", &BeaconParams::elevationError, "rad", 0, 45),
                     field("maxDistance", &BeaconParams::maxDistance, "cm", 50, 1000),
                     field("edgeSd", &BeaconParams::edgeSd, "px", 0.01, 5),
                     field("headingSd", &BeaconParams::headingSd, "rad", 0.01, 20));
  }
};

struct GoalParams {
  double minSamples = 20;                // lattice samples
  double minWidth = 8;                   // px
  double minHeight = 5;                  // px
  double maxTall = 1.3;                  // height to width of a goal that no image border cuts
  double maxFlat = 4.5;                  // width to height; 80 : 30 seen from the front is 2.7
  double maxAboveHorizon = 12;           // px, of the lower edge: facts-2005 4.5 check 7 has 20
  double maxAboveFieldEdge = 6;          // px, of the lower edge
  double minFieldColumns = 0.4;          // share of columns with green below, check 8
  double minSeenWidth = 40;              // cm between the posts, seen half from the side
  double minCutWidth = 25;               // cm of a goal that the image border cuts
  double maxSeenWidth = 125;             // cm, with a side wall seen from outside
  Angle directionError = Angle::deg(4);  // camera against ground, for goalOffGround
  double maxDistance = 620;
  double depth = 30;                  // cm from the back wall, which is measured, to the mouth
  double edgeSd = 0.5;                // px, of the upper and of the lower edge
  Angle directionSd = Angle::deg(1);  // camera against ground, while walking
  Angle headingSd = Angle::deg(1);

  static constexpr auto fields() {
    return fieldList(field("minSamples", &GoalParams::minSamples, "", 1, 1000),
                     field("minWidth", &GoalParams::minWidth, "px", 1, 100),
                     field("minHeight", &GoalParams::minHeight, "px", 1, 100),
                     field("maxTall", &GoalParams::maxTall, "", 0.1, 10),
                     field("maxFlat", &GoalParams::maxFlat, "", 1, 50),
                     field("maxAboveHorizon", &GoalParams::maxAboveHorizon, "px", -160, 160),
                     field("maxAboveFieldEdge", &GoalParams::maxAboveFieldEdge, "px", -160, 160),
                     field("minFieldColumns", &GoalParams::minFieldColumns, "", 0, 1),
                     field("minSeenWidth", &GoalParams::minSeenWidth, "cm", 0, 200),
                     field("minCutWidth", &GoalParams::minCutWidth, "cm", 0, 200),
                     field("maxSeenWidth", &GoalParams::maxSeenWidth, "cm", 0, 500),
                     field("directionError", &GoalParams::directionError, "rad", 0, 20),
                     field("maxDistance", &GoalParams::maxDistance, "cm", 50, 1000),
                     field("depth", &GoalParams::depth, "cm", 0, 60),
                     field("edgeSd", &GoalParams::edgeSd, "px", 0.01, 5),
                     field("directionSd", &GoalParams::directionSd, "rad", 0.05, 20),
                     field("headingSd", &GoalParams::headingSd, "rad", 0.01, 20));
  }
};

struct FieldEdgeParams {
  double rounds = 10;         // checklist
  double tolerance = 3;       // px, of an inlier
  double minColumns = 12;     // of 50
  double minShare = 0.5;      // inliers among the columns that end inside the image
  double minGreen = 0.6;      // share of green in the 16 px below the edge
  std::uint32_t seed = 2006;  // of the sampling, afresh for each image

  static constexpr auto fields() {
    return fieldList(field("rounds", &FieldEdgeParams::rounds, "", 1, 100),
                     field("tolerance", &FieldEdgeParams::tolerance, "px", 0.5, 20),
                     field("minColumns", &FieldEdgeParams::minColumns, "", 2, 50),
                     field("minShare", &FieldEdgeParams::minShare, "", 0, 1),
                     field("minGreen", &FieldEdgeParams::minGreen, "", 0, 1),
                     field("seed", &FieldEdgeParams::seed));
  }
};

struct LineParams {
  double minStep = 15;                 // grey levels of Y at both edges, facts-2005 4.2
  double maxChroma = 40;               // grey levels that Cr and Cb may change by
  double maxWidth = 18;                // px
  double maxPerColumn = 6;             // more: the column shows a robot or the crowd
  double fullWeight = 70;              // cm, thesis 2004 3.1.4
  double noWeight = 350;               // cm
  Angle maxHeadSpeed = Angle::deg(3);  // per frame, checklist U11

  static constexpr auto fields() {
    return fieldList(field("minStep", &LineParams::minStep, "", 1, 100),
                     field("maxChroma", &LineParams::maxChroma, "", 1, 255),
                     field("maxWidth", &LineParams::maxWidth, "px", 1, 60),
                     field("maxPerColumn", &LineParams::maxPerColumn, "", 1, 30),
                     field("fullWeight", &LineParams::fullWeight, "cm", 1, 500),
                     field("noWeight", &LineParams::noWeight, "cm", 2, 1000),
                     field("maxHeadSpeed", &LineParams::maxHeadSpeed, "rad/frame", 0, 180));
  }
};

struct VisionParams {
  BallParams ball;
  BeaconParams beacon;
  GoalParams goal;
  FieldEdgeParams fieldEdge;
  LineParams line;
  RobotParams robot;
  PinkParams pink;
  ObstacleParams obstacle;

  static constexpr auto fields() {
    return fieldList(
        field("ball", &VisionParams::ball), field("beacon", &VisionParams::beacon),
        field("goal", &VisionParams::goal), field("fieldEdge", &VisionParams::fieldEdge),
        field("line", &VisionParams::line), field("robot", &VisionParams::robot),
        field("pink", &VisionParams::pink), field("obstacle", &VisionParams::obstacle));
  }
};

}  // namespace kelpie::vision
