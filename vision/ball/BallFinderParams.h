// SPDX-License-Identifier: Apache-2.0
// Tunables of the search for the ball. The checks' limits are wide: what passes them is judged by
// the log odds of its facts.
#pragma once

#include "robot/core/Angle.h"
#include "robot/core/fields/Fields.h"

namespace kelpie::vision {

struct BallFinderParams {
  double minSamples = 2;              // lattice samples of orange
  double minEdgePoints = 5;           // of 16 spokes
  double maxCircleError = 0.1;        // rms of the edge points, in radii
  double minCircleError = 0.6;        // px, allowed of the smallest: edges are whole pixels
  double minOrangeShare = 0.2;        // of the circle; a robot may hide much of it
  double maxOtherShare = 0.35;        // of pink, yellow and robot red together, of the circle
  double minFieldShare = 0.1;         // of seven points beside and below: one is carpet
  double maxAboveHorizon = 10;        // facts-2005 4.5 check 1
  double maxAboveFieldEdge = 2;       // px, of the ball's lowest point
  double maxHeightError = 2;          // of ballHeightError
  double maxDistance = 420;           // beyond, most orange of under two pixels' radius is clothes
  double maxLogOddsAgainst = 0;       // of the candidate's facts (BallCurves.h)
  Angle directionSd = Angle::deg(1);  // of the camera against the ground while walking
  double edgeSd = 0.3;                // px, of the radius
  // Of a camera (`kelpie calibrate body FOLDER`): px by which a measured radius is larger than the
  // true one, and the sd of the blur, which makes a small disc's radius r smaller by
  // blur^2 / (2 r).
  double edgeBias = 0.0;
  double blur = 0.0;
  double minRangeShare = 0.02;  // of the range: its least sd, as gps believes (minShare there);
                                // by edges alone an orange thing at 21 cm had 0.1 cm
  Angle headingSd = Angle::deg(0.7);

  template <int = 0>
  static constexpr auto fields() {
    using P = BallFinderParams;
    return fieldList(
        field("minSamples", &P::minSamples, "", 1, 100),
        field("minEdgePoints", &P::minEdgePoints, "", 4, 16),
        field("maxCircleError", &P::maxCircleError, "", 0, 1),
        field("minCircleError", &P::minCircleError, "px", 0, 5),
        field("minOrangeShare", &P::minOrangeShare, "", 0, 1),
        field("maxOtherShare", &P::maxOtherShare, "", 0, 1),
        field("minFieldShare", &P::minFieldShare, "", 0, 1),
        field("maxAboveHorizon", &P::maxAboveHorizon, "px", -160, 160),
        field("maxAboveFieldEdge", &P::maxAboveFieldEdge, "px", -160, 160),
        field("maxHeightError", &P::maxHeightError, "", 0, 20),
        field("maxDistance", &P::maxDistance, "cm", 50, 1000),
        field("maxLogOddsAgainst", &P::maxLogOddsAgainst, "", -50, 50),
        field("directionSd", &P::directionSd, "rad", 0.05, 20),
        field("edgeSd", &P::edgeSd, "px", 0.01, 5), field("edgeBias", &P::edgeBias, "px", -5, 5),
        field("blur", &P::blur, "px", 0, 5), field("minRangeShare", &P::minRangeShare, "", 0, 1),
        field("headingSd", &P::headingSd, "rad", 0.01, 20));
  }
};

}  // namespace kelpie::vision
