// SPDX-License-Identifier: Apache-2.0
// Vision's tunables by object. Where a number is not explained here, README.md gives its source.
#pragma once

#include <cstdint>

#include "robot/body/FieldDescription.h"
#include "robot/core/Angle.h"
#include "robot/core/Fields.h"
#include "vision/FieldEdgeParams.h"
#include "vision/LinePointParams.h"
#include "vision/ObstacleParams.h"
#include "vision/PinkFinderParams.h"
#include "vision/RobotFinderParams.h"

namespace kelpie::vision {

struct BallFinderParams {
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
  Angle directionSd = Angle::deg(1);       // its standard deviation while walking
  double edgeSd = 0.3;                     // px, of the radius
  Angle headingSd = Angle::deg(0.7);

  static constexpr auto fields() {
    return fieldList(
        field("minSamples", &BallFinderParams::minSamples, "", 1, 100),
        field("minEdgePoints", &BallFinderParams::minEdgePoints, "", 4, 16),
        field("maxCircleError", &BallFinderParams::maxCircleError, "", 0, 1),
        field("minCircleError", &BallFinderParams::minCircleError, "px", 0, 5),
        field("minOrangeShare", &BallFinderParams::minOrangeShare, "", 0, 1),
        field("maxOtherShare", &BallFinderParams::maxOtherShare, "", 0, 1),
        field("maxAboveHorizon", &BallFinderParams::maxAboveHorizon, "px", -160, 160),
        field("maxAboveFieldEdge", &BallFinderParams::maxAboveFieldEdge, "px", -160, 160),
        field("maxAboveShare", &BallFinderParams::maxAboveShare, "", 0, 2),
        field("maxPatch", &BallFinderParams::maxPatch, "", 1, 100),
        field("minFieldPoints", &BallFinderParams::minFieldPoints, "", 0, 7),
        field("maxDistance", &BallFinderParams::maxDistance, "cm", 50, 1000),
        field("directionError", &BallFinderParams::directionError, "rad", 0, 20),
        field("directionSd", &BallFinderParams::directionSd, "rad", 0.05, 20),
        field("edgeSd", &BallFinderParams::edgeSd, "px", 0.01, 5),
        field("headingSd", &BallFinderParams::headingSd, "rad", 0.01, 20));
  }
};

struct BeaconFinderParams {
  double minSamples = 2;             // lattice samples of pink
  double minBand = 2.0;              // px, each coloured band
  double maxRatio = 1.6;             // of the two bands' heights
  double maxAspect = 1.6;            // width to height of a band, and its inverse; the rule is 1
  double maxBelowHorizon = 25;       // px, facts-2005 4.5 check 5
  double minWhiteShare = 0.3;        // of the two bands below the coloured part
  double minUnsureWhiteShare = 0.5;  // of them, where the height does not fit the size well
  double maxFootAboveEdge = 4;       // px, of where its foot should be from the field edge
  double maxFootBelowEdge = 0.9;     // bands: beacons stand at most 20 cm inside the carpet's edge
  double maxBandWidths = 8;          // of its wider band to its width, where no white told its foot
  double maxCutBandWidths = 3;       // of them, when a band's end is hidden or cut
  Angle elevationError = Angle::deg(1.7);  // the camera's tilt is known to about a degree
  Angle sureElevation = Angle::deg(0.4);   // so small an error makes up for what is hidden or cut
  double maxSureAspect = 2.2;
  double maxWeakCues = 3;    // of the eight that weakCues counts
  double maxDistance = 500;  // beyond, two pixels of clothes pass for a band
  double edgeSd = 0.35;      // px, of each band edge
  Angle headingSd = Angle::deg(0.7);

  static constexpr auto fields() {
    return fieldList(
        field("minSamples", &BeaconFinderParams::minSamples, "", 1, 100),
        field("minBand", &BeaconFinderParams::minBand, "px", 1, 50),
        field("maxRatio", &BeaconFinderParams::maxRatio, "", 1, 10),
        field("maxAspect", &BeaconFinderParams::maxAspect, "", 1, 10),
        field("maxBelowHorizon", &BeaconFinderParams::maxBelowHorizon, "px", -160, 160),
        field("minWhiteShare", &BeaconFinderParams::minWhiteShare, "", 0, 1),
        field("minUnsureWhiteShare", &BeaconFinderParams::minUnsureWhiteShare, "", 0, 1),
        field("maxFootAboveEdge", &BeaconFinderParams::maxFootAboveEdge, "px", 0, 160),
        field("maxFootBelowEdge", &BeaconFinderParams::maxFootBelowEdge, "", 0, 20),
        field("sureElevation", &BeaconFinderParams::sureElevation, "rad", 0, 45),
        field("maxSureAspect", &BeaconFinderParams::maxSureAspect, "", 1, 10),
        field("maxBandWidths", &BeaconFinderParams::maxBandWidths, "", 1, 100),
        field("maxCutBandWidths", &BeaconFinderParams::maxCutBandWidths, "", 1, 100),
        field("elevationError", &BeaconFinderParams::elevationError, "rad", 0, 45),
        field("maxWeakCues", &BeaconFinderParams::maxWeakCues, "", 0, 8),
        field("maxDistance", &BeaconFinderParams::maxDistance, "cm", 50, 1000),
        field("edgeSd", &BeaconFinderParams::edgeSd, "px", 0.01, 5),
        field("headingSd", &BeaconFinderParams::headingSd, "rad", 0.01, 20));
  }
};

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
  double width = 80;                  // cm, of the mouth
  double depth = 30;                  // cm from the mouth to the back wall
  Angle maxTurn = Angle::deg(80);     // of the mouth from square to the line of sight
  double maxLateralOffset = 450;      // cm from the goal's axis: half the field, and a turn's error
  double edgeSd = 0.5;                // px, of the upper and of the lower edge
  Angle directionSd = Angle::deg(1);  // camera against ground, while walking
  Angle headingSd = Angle::deg(1);

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
        field("width", &GoalFinderParams::width, "cm", 20, 200),
        field("depth", &GoalFinderParams::depth, "cm", 0, 60),
        field("edgeSd", &GoalFinderParams::edgeSd, "px", 0.01, 5),
        field("directionSd", &GoalFinderParams::directionSd, "rad", 0.05, 20),
        field("headingSd", &GoalFinderParams::headingSd, "rad", 0.01, 20));
  }
};

struct VisionParams {
  body::FieldDescription field = *body::fieldDescription("2006");  // the loader may set another
  BallFinderParams ball;
  BeaconFinderParams beacon;
  GoalFinderParams goal;
  HorizonScanParams scan;
  FieldEdgeParams fieldEdge;
  LinePointParams line;
  RobotFinderParams robot;
  PinkFinderParams pink;
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
