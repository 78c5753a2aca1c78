// SPDX-License-Identifier: Apache-2.0
// Plain facts that tell whether the circle of an orange patch is the ball (BallCurves.h). Clothes
// and shoes look like one in some facts, seldom in all. Weak where the circle has two pixels.
#pragma once

#include "robot/core/fields/Fields.h"
#include "vision/ball/BallCandidate.h"

namespace kelpie::vision {

struct BallFacts {
  double range = 0.0;         // cm, by size
  double radius = 0.0;        // px
  double edges = 0.0;         // spokes that end on the circle
  double cut = 0.0;           // spokes that the image's border cuts
  double circleError = 0.0;   // of them, rms in radii, less that of whole pixels
  double orange = 0.0;        // share of the circle
  double otherColour = 0.0;   // share that is pink, yellow or robot red
  double green = 0.0;         // share
  double patch = 0.0;         // log of the patch's area to the circle's
  double beside = 0.0;        // share of the points right outside the circle that are orange
  double goalBelow = 0.0;     // share of three points below it of a goal's colours
  double carpetAround = 0.0;  // share of seven points beside and below that are carpet
  // Px, of its centre, with no more of an error of elevation than counts in settled play.
  double belowHorizon = 0.0;
  double edgeShows = 0.0;      // 1: a field edge is in the image
  double footBelowEdge = 0.0;  // px, of its lowest point from that; 0 without one
  double footBelowInRadii = 0.0;
  double heightError = 0.0;  // of ballHeightError
  double standsAlone = 0.0;  // 1: all of the patch should be the ball

  template <int = 0>
  static constexpr auto fields() {
    using Facts = BallFacts;
    return fieldList(
        field("range", &Facts::range), field("radius", &Facts::radius),
        field("edges", &Facts::edges), field("cut", &Facts::cut),
        field("circleError", &Facts::circleError), field("orange", &Facts::orange),
        field("otherColour", &Facts::otherColour), field("green", &Facts::green),
        field("patch", &Facts::patch), field("beside", &Facts::beside),
        field("goalBelow", &Facts::goalBelow), field("carpetAround", &Facts::carpetAround),
        field("belowHorizon", &Facts::belowHorizon), field("edgeShows", &Facts::edgeShows),
        field("footBelowEdge", &Facts::footBelowEdge),
        field("footBelowInRadii", &Facts::footBelowInRadii),
        field("heightError", &Facts::heightError), field("standsAlone", &Facts::standsAlone));
  }
};

BallFacts ballFacts(const Scene& scene, const BallCandidate& c);

}  // namespace kelpie::vision
