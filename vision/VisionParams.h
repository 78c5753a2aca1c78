// SPDX-License-Identifier: Apache-2.0
// Vision's tunables by object. Where a number is not explained here, README.md gives its source.
#pragma once

#include <cstdint>

#include "robot/body/FieldDescription.h"
#include "robot/core/Angle.h"
#include "robot/core/Fields.h"
#include "vision/FieldEdgeParams.h"
#include "vision/LineParams.h"
#include "vision/ObstacleParams.h"
#include "vision/PinkParams.h"
#include "vision/RobotParams.h"

namespace kelpie::vision {

struct BallParams {
  double minSamples = 2;             // lattice samples of orange
  double minEdgePoints = 5;          // of 16 spokes
  double maxCircleError = 0.05;      // rms of the edge points, in radii
  double minCircleError = 0.3;       // px, allowed of the smallest: edges are whole pixels
  double minOrangeShare = 0.4;       // of the circle; a robot may hide half of it
  double maxOtherShare = 0.35;       // of pink, yellow and robot red together, of the circle
  double maxAboveHorizon = 10;       // facts-2005 4.5 check 1
  double maxAboveFieldEdge = -0.25;  // px, of the ball's lowest point: it stands inside
  double maxAboveShare = 0.03;       // more for each px of radius
  double maxPatch = 1.6;             // area of the orange patch to that of the circle
  double minFieldPoints = 2;         // green or lower image border among 7 points beside and below
  double maxDistance = 390;          // beyond, most orange of under two pixels' radius is clothes
  Angle directionError = Angle::deg(1.7);  // camera against ground, for ballOffGround
  Angle directionSd = Angle::deg(1);       // the same as a standard deviation, while walking
  double edgeSd = 0.3;                     // px, of the radius
  Angle headingSd = Angle::deg(0.7);

  static constexpr auto fields() {
    return fieldList(field("minSamples", &BallParams::minSamples, "", 1, 100),
                     field("minEdgePoints", &BallParams::minEdgePoints, "", 4, 16),
                     field("maxCircleError", &BallParams::maxCircleError, "", 0, 1),
                     field("minCircleError", &BallParams::minCircleError, "px", 0, 5),
                     field("minOrangeShare", &BallParams::minOrangeShare, "", 0, 1),
                     field("maxOtherShare", &BallParams::maxOtherShare, "", 0, 1),
                     field("maxAboveHorizon", &BallParams::maxAboveHorizon, "px", -160, 160),
                     field("maxAboveFieldEdge", &BallParams::maxAboveFieldEdge, "px", -160, 160),
                     field("maxAboveShare", &BallParams::maxAboveShare, "", 0, 2),
                     field("maxPatch", &BallParams::maxPatch, "", 1, 100),
                     field("minFieldPoints", &BallParams::minFieldPoints, "", 0, 7),
                     field("maxDistance", &BallParams::maxDistance, "cm", 50, 1000),
                     field("directionError", &BallParams::directionError, "rad", 0, 20),
                     field("directionSd", &BallParams::directionSd, "rad", 0.05, 20),
                     field("edgeSd", &BallParams::edgeSd, "px", 0.01, 5),
                     field("headingSd", &BallParams::headingSd, "rad", 0.01, 20));
  }
};

struct BeaconParams {
  double minSamples = 2;             // lattice samples of pink
  double minBand = 2.0;              // px, each coloured band
  double maxRatio = 1.6;             // of the two bands' heights
  double maxAspect = 1.6;            // width to height of a band, and its inverse; the rule is 1
  double maxBelowHorizon = 25;       // px, facts-2005 4.5 check 5
  double minWhiteShare = 0.3;        // of the two bands below the coloured part
  double minUnsureWhiteShare = 0.5;  // the same where the height does not fit the size well
  double maxFootAboveEdge = 4;       // px, of where its foot should be from the field edge
  double maxFootBelowEdge = 0.9;     // bands: beacons stand at most 20 cm inside the carpet's edge
  double maxBandWidths = 8;          // of its wider band to its width, where no white told its foot
  double maxCutBandWidths = 3;       // the same when a band's end is hidden or cut
  Angle elevationError = Angle::deg(1.7);  // the camera's tilt is known to about a degree
  Angle sureElevation = Angle::deg(0.4);   // so small an error makes up for what is hidden or cut
  double maxSureAspect = 2.2;
  double maxDoubts = 3;      // of the eight that beaconDoubts counts
  double maxDistance = 500;  // beyond, two pixels of clothes pass for a band
  double edgeSd = 0.35;      // px, of each band edge
  Angle headingSd = Angle::deg(0.7);

  static constexpr auto fields() {
    return fieldList(field("minSamples", &BeaconParams::minSamples, "", 1, 100),
                     field("minBand", &BeaconParams::minBand, "px", 1, 50),
                     field("maxRatio", &BeaconParams::maxRatio, "", 1, 10),
                     field("maxAspect", &BeaconParams::maxAspect, "", 1, 10),
                     field("maxBelowHorizon", &BeaconParams::maxBelowHorizon, "px", -160, 160),
                     field("minWhiteShare", &BeaconParams::minWhiteShare, "", 0, 1),
                     field("minUnsureWhiteShare", &BeaconParams::minUnsureWhiteShare, "", 0, 1),
                     field("maxFootAboveEdge", &BeaconParams::maxFootAboveEdge, "px", 0, 160),
                     field("maxFootBelowEdge", &BeaconParams::maxFootBelowEdge, "", 0, 20),
                     field("sureElevation", &BeaconParams::sureElevation, "rad", 0, 45),
                     field("maxSureAspect", &BeaconParams::maxSureAspect, "", 1, 10),
                     field("maxBandWidths", &BeaconParams::maxBandWidths, "", 1, 100),
                     field("maxCutBandWidths", &BeaconParams::maxCutBandWidths, "", 1, 100),
                     field("elevationError", &BeaconParams::elevationError, "rad", 0, 45),
                     field("maxDoubts", &BeaconParams::maxDoubts, "", 0, 8),
                     field("maxDistance", &BeaconParams::maxDistance, "cm", 50, 1000),
                     field("edgeSd", &BeaconParams::edgeSd, "px", 0.01, 5),
                     field("headingSd", &BeaconParams::headingSd, "rad", 0.01, 20));
  }
};

struct GoalParams {
  double minSamples = 20;                  // lattice samples
  double minWidth = 8;                     // px
  double minHeight = 5;                    // px
  double maxTall = 3;                      // height to width of a goal that no image border cuts
  double maxFlat = 8;                      // width to height; 80 : 30 seen from the front is 2.7
  double maxAboveHorizon = 12;             // px, of the lower edge: facts-2005 4.5 check 7 has 20
  double maxAboveFieldEdge = 1.6;          // px, of the lowest foot
  double maxMeanAboveFieldEdge = 5;        // px, of all feet
  double minFieldColumns = 0.1;            // share of columns with green below, check 8
  double minSeenWidth = 18;                // cm between the ends, seen 60 deg from the side: 66
  double minCutWidth = 15;                 // cm of a goal that the image border cuts
  double minHiddenWidth = 12;              // cm between two robots that hide both posts
  double maxSeenWidth = 170;               // cm, with a side wall seen from outside
  Angle directionError = Angle::deg(2.2);  // a column's foot against the ground at its distance
  double maxPartWidth = 65;  // cm of a goal that would stand aslant if its ends were posts
  double minPartBelowFieldEdge =
      -0.1;  // px, of such a part's lowest foot: a box beyond it has less
  double maxPartMeanAboveFieldEdge = 0.8;  // px, of all its feet
  Angle partDirection = Angle::deg(0.3);   // of its feet against the ground
  double maxDoubt = -0.3;                  // log odds, see GoalDoubt.h
  double maxDistance = 560;           // the opposite goal's back wall, seen from the own mouth: 570
  double width = 80;                  // cm, of the mouth
  double depth = 30;                  // cm from the mouth to the back wall
  Angle maxTurn = Angle::deg(80);     // of the mouth from square to the sight
  double maxAside = 450;              // cm from the goal's axis: half the field, and a turn's error
  double edgeSd = 0.5;                // px, of the upper and of the lower edge
  Angle directionSd = Angle::deg(1);  // camera against ground, while walking
  Angle headingSd = Angle::deg(1);

  static constexpr auto fields() {
    return fieldList(
        field("minSamples", &GoalParams::minSamples, "", 1, 1000),
        field("minWidth", &GoalParams::minWidth, "px", 1, 100),
        field("minHeight", &GoalParams::minHeight, "px", 1, 100),
        field("maxTall", &GoalParams::maxTall, "", 0.1, 10),
        field("maxFlat", &GoalParams::maxFlat, "", 1, 50),
        field("maxAboveHorizon", &GoalParams::maxAboveHorizon, "px", -160, 160),
        field("maxAboveFieldEdge", &GoalParams::maxAboveFieldEdge, "px", -160, 160),
        field("maxMeanAboveFieldEdge", &GoalParams::maxMeanAboveFieldEdge, "px", -160, 160),
        field("minFieldColumns", &GoalParams::minFieldColumns, "", 0, 1),
        field("minSeenWidth", &GoalParams::minSeenWidth, "cm", 0, 200),
        field("minCutWidth", &GoalParams::minCutWidth, "cm", 0, 200),
        field("minHiddenWidth", &GoalParams::minHiddenWidth, "cm", 0, 200),
        field("maxSeenWidth", &GoalParams::maxSeenWidth, "cm", 0, 500),
        field("directionError", &GoalParams::directionError, "rad", 0, 20),
        field("maxPartWidth", &GoalParams::maxPartWidth, "cm", 0, 200),
        field("minPartBelowFieldEdge", &GoalParams::minPartBelowFieldEdge, "px", -160, 160),
        field("maxPartMeanAboveFieldEdge", &GoalParams::maxPartMeanAboveFieldEdge, "px", -160, 160),
        field("partDirection", &GoalParams::partDirection, "rad", 0, 20),
        field("maxDoubt", &GoalParams::maxDoubt, "", -20, 20),
        field("maxDistance", &GoalParams::maxDistance, "cm", 50, 1000),
        field("maxTurn", &GoalParams::maxTurn, "rad", 0, 90),
        field("maxAside", &GoalParams::maxAside, "cm", 0, 2000),
        field("width", &GoalParams::width, "cm", 20, 200),
        field("depth", &GoalParams::depth, "cm", 0, 60),
        field("edgeSd", &GoalParams::edgeSd, "px", 0.01, 5),
        field("directionSd", &GoalParams::directionSd, "rad", 0.05, 20),
        field("headingSd", &GoalParams::headingSd, "rad", 0.01, 20));
  }
};

struct VisionParams {
  body::FieldDescription field = *body::fieldDescription("2006");  // the loader may set another
  BallParams ball;
  BeaconParams beacon;
  GoalParams goal;
  ScanParams scan;
  FieldEdgeParams fieldEdge;
  LineParams line;
  RobotParams robot;
  PinkParams pink;
  ObstacleParams obstacle;

  static constexpr auto fields() {
    using kelpie::field;
    return fieldList(
        field("field", &VisionParams::field), field("ball", &VisionParams::ball),
        field("beacon", &VisionParams::beacon), field("goal", &VisionParams::goal),
        field("scan", &VisionParams::scan), field("fieldEdge", &VisionParams::fieldEdge),
        field("line", &VisionParams::line), field("robot", &VisionParams::robot),
        field("pink", &VisionParams::pink), field("obstacle", &VisionParams::obstacle));
  }
};

}  // namespace kelpie::vision
