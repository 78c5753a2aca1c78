// SPDX-License-Identifier: Apache-2.0
// Tunables of the search for the ball.
#pragma once

#include "robot/core/Angle.h"
#include "robot/core/Fields.h"

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

}  // namespace kelpie::vision
