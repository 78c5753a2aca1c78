// SPDX-License-Identifier: Apache-2.0
// Where an orange patch may be a ball: its outline, sought along spokes at full resolution, as a
// cone. From the middle of the patch, or from its foot where orange clothes touch the ball's image.
// Wrong where something hides more than half of the outline.
#pragma once

#include "vision/Scene.h"
#include "vision/ball/BallFinderParams.h"
#include "vision/ball/ConeFit.h"

namespace kelpie::vision {

struct BallCandidate {
  const Blob* blob = nullptr;
  bool standsAlone = true;  // all of the patch should be the ball; false: clothes touch it
  std::size_t cut = 0;      // spokes that end at the image's border
  Cone cone;
  double range = 0.0;  // cm from the camera to the centre, by size
  Point3<Robot> axis;  // unit vector to the centre
};

BallCandidate ballFromMiddle(const Scene& scene, const Blob& blob, const BallFinderParams& p);
// A ball as large as one that stands where the patch ends below.
BallCandidate ballFromFoot(const Scene& scene, const Blob& blob, const BallFinderParams& p);

// The height of its centre above that of a ball that lies on the ground, in tolerances: the error
// of the camera's direction and of its size.
double ballHeightError(const Scene& scene, const BallCandidate& c);

// Elevation of its centre less that of a ball on the ground at the range that its size tells, rad;
// and the same as it would count in settled play (ElevationDoubt.h).
double ballElevationError(const Scene& scene, const BallCandidate& c);
double settledBallElevationError(const Scene& scene, const BallCandidate& c);

}  // namespace kelpie::vision
