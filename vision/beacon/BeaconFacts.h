// SPDX-License-Identifier: Apache-2.0
// Plain facts that tell whether a pink and a blue or yellow band are a beacon (BeaconCurves.h).
// Clothes look like one in some facts, seldom in all. Weak where the image shows one band only, and
// where another robot hides the white part.
#pragma once

#include "robot/core/fields/Fields.h"
#include "vision/beacon/BeaconCandidate.h"

namespace kelpie::vision {

struct BeaconFacts {
  double distance = 0.0;   // cm
  double band = 0.0;       // px, height of one
  double bandRatio = 0.0;  // log of the larger band to the smaller; 0 where one is cut
  double aspect = 0.0;     // log of width to height of a band; the rule is 0
  double wider = 0.0;      // log of the wider band, with what touches it, to the width
  // Deg, of its height from that which its size tells, as it would count in settled play; and px of
  // the bands' border with no more of an error than that (ElevationDoubt.h).
  double elevationError = 0.0;
  double belowHorizon = 0.0;
  double whiteShare = 0.0;     // of what shows of the two bands below the coloured ones
  double whiteShows = 0.0;     // share of these two that the image shows
  double edgeShows = 0.0;      // 1: a field edge is in the image
  double footBelowEdge = 0.0;  // bands, of where its foot should be from that; 0 without one
  double strangeBelow = 0.0;   // bands, longest stretch of no carpet, robot or ball below the white
  double filled = 0.0;         // share of points in its bands that have their colour
  double beside = 0.0;         // share of points beside its bands that have it as well
  double onWhite = 0.0;        // 1: found upwards from its white part
  double topCut = 0.0;         // 1: its upper end is unknown
  double bottomCut = 0.0;
  double widthCut = 0.0;  // 1: by the image's border, and not too wide all the same

  template <int = 0>
  static constexpr auto fields() {
    using Facts = BeaconFacts;
    return fieldList(
        field("distance", &Facts::distance), field("band", &Facts::band),
        field("bandRatio", &Facts::bandRatio), field("aspect", &Facts::aspect),
        field("wider", &Facts::wider), field("elevationError", &Facts::elevationError),
        field("belowHorizon", &Facts::belowHorizon), field("whiteShare", &Facts::whiteShare),
        field("whiteShows", &Facts::whiteShows), field("edgeShows", &Facts::edgeShows),
        field("footBelowEdge", &Facts::footBelowEdge), field("strangeBelow", &Facts::strangeBelow),
        field("filled", &Facts::filled), field("beside", &Facts::beside),
        field("onWhite", &Facts::onWhite), field("topCut", &Facts::topCut),
        field("bottomCut", &Facts::bottomCut), field("widthCut", &Facts::widthCut));
  }
};

BeaconFacts beaconFacts(const Scene& scene, const BeaconCandidate& c);

}  // namespace kelpie::vision
