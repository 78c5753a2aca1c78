// SPDX-License-Identifier: Apache-2.0
// What may be a beacon: a pink band with a blue or yellow one right above or below. Both are
// measured along the image's upward direction, so a neighbouring goal of the same colour does no
// harm. A band that runs on into clothes of its colour has no end there. Distance from the angle
// that the 20 cm of both bands fill, whatever the camera's height and tilt.
#pragma once

#include "vision/Scene.h"
#include "vision/beacon/BeaconFeet.h"
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
};

// At a pink point, its partner colour on one side. Without a partner there is none.
BeaconCandidate beaconFromPink(const Scene& scene, PixelPoint pink, bool pinkIsLower);
// Upwards from its white part.
BeaconCandidate beaconFromFoot(const Scene& scene, const BeaconFoot& foot);
// Its width, its distance, and which of its ends show; its axis moves to its middle.
void measure(const Scene& scene, const BeaconFinderParams& p, BeaconCandidate& c);

constexpr double kBandsBelowMiddle = 3.0;  // from the ground to where the colours meet
// Four bands of one height, the upper two coloured (facts-2005 section 1): cm of one.
double bandHeight(const Scene& scene);
// The height of a band that the image shows whole, in px.
double bandOf(const BeaconCandidate& c);
// Elevation of the bands' border less that of 30 cm at the distance that their size tells, rad.
double elevationError(const Scene& scene, const BeaconCandidate& c);
// The same as it would count in settled play (ElevationDoubt.h).
double settledElevationError(const Scene& scene, const BeaconCandidate& c);

}  // namespace kelpie::vision
