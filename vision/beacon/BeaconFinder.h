// SPDX-License-Identifier: Apache-2.0
// Beacons: a pink band with a blue or yellow one right above or below, over white. Both are
// measured along the image's upward direction, so a neighbouring goal of the same colour does no
// harm. Sought upwards from the white (BeaconFeet) and, in case something hides that, from the
// middle of every pink blob. A band that runs on into clothes of its colour has no end there.
// Distance from the angle that the 20 cm of both bands fill, whatever the camera's height and tilt.
#pragma once

#include "robot/core/Percepts.h"
#include "vision/Scene.h"
#include "vision/beacon/BeaconFinderParams.h"

namespace kelpie::vision {

struct BeaconCandidate {
  PixelPoint pink;       // a point inside the pink band
  bool onWhite = false;  // found upwards from its white part
  ColourClass partner = ColourClass::none;
  bool pinkIsLower = false;
  PixelPoint top;     // of the coloured part
  PixelPoint middle;  // where the colours meet
  PixelPoint bottom;
  bool topCut = false;
  bool bottomCut = false;
  double upper = 0.0;  // px, height of the upper band
  double lower = 0.0;
  double width = 0.0;   // px, of the narrower band
  double widest = 0.0;  // px, of the wider band, with what touches it
  bool widthCut = false;
  double distance = 0.0;  // cm on the ground, camera to the beacon's axis
  bool sure = false;      // its height fits its size so well that parts of it may be hidden or cut
};

// The checks: true = keep.
bool beaconHasPartner(const BeaconCandidate& c);
bool beaconIsLarge(const BeaconCandidate& c, const BeaconFinderParams& p);
bool beaconBandsAreEqual(const BeaconCandidate& c, const BeaconFinderParams& p);
bool beaconBandIsSquare(const BeaconCandidate& c, const BeaconFinderParams& p);
bool beaconBandsStandAlone(const BeaconCandidate& c, const BeaconFinderParams& p);
bool beaconReachesHorizon(const Scene& scene, const BeaconCandidate& c,
                          const BeaconFinderParams& p);
bool beaconHasWhiteBelow(const Scene& scene, const BeaconCandidate& c, const BeaconFinderParams& p);
bool beaconIsInImage(const BeaconCandidate& c);
bool beaconStandsAtFieldEdge(const Scene& scene, const BeaconCandidate& c,
                             const BeaconFinderParams& p);
bool beaconStandsOnField(const Scene& scene, const BeaconCandidate& c);
bool beaconHeightFitsSize(const Scene& scene, const BeaconCandidate& c,
                          const BeaconFinderParams& p);
bool beaconIsNear(const BeaconCandidate& c, const BeaconFinderParams& p);

// How many of eight cues are weak though no check refuses any: height and size, bands alike and
// square, white below, foot at the edge, colours that go on beside it. One is forgiven when the
// image border cuts its width. Trousers over socks have three, so has one beacon in 90.
int weakCues(const Scene& scene, const BeaconCandidate& c);

void findBeacons(const Scene& scene, const BeaconFinderParams& params, VisionCounts& counts,
                 Landmarks& landmarks);

}  // namespace kelpie::vision
