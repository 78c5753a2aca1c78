// SPDX-License-Identifier: Apache-2.0
// The ball: the largest orange blob that passes every check. Its outline is sought along spokes at
// full resolution; distance from the outline's cone and from the ground below it, fused.
#pragma once

#include "vision/Scene.h"
#include "vision/ball/BallFinderParams.h"
#include "vision/ball/ConeFit.h"

namespace kelpie::vision {

struct BallCandidate {
  const Blob* blob = nullptr;
  bool standsAlone = true;  // all of the patch should be the ball; false: clothes touch it
  Cone cone;
  double range = 0.0;  // cm from the camera to the centre, by size
  Point3<Robot> axis;  // unit vector to the centre
};

// The checks, each alone so that each can be tested: true = keep.
bool ballHasEdges(const BallCandidate& c, const BallFinderParams& p);
bool ballIsRound(const BallCandidate& c, const BallFinderParams& p);
bool ballIsOrange(const Scene& scene, const BallCandidate& c, const BallFinderParams& p);
bool ballHasNoOtherColour(const Scene& scene, const BallCandidate& c, const BallFinderParams& p);
bool ballFillsItsPatch(const BallCandidate& c, const BallFinderParams& p);
bool ballStandsOnNoGoal(const Scene& scene, const BallCandidate& c);
bool ballIsBelowHorizon(const Scene& scene, const BallCandidate& c, const BallFinderParams& p);
bool ballIsInsideFieldEdge(const Scene& scene, const BallCandidate& c, const BallFinderParams& p);
bool ballHasFieldAround(const Scene& scene, const BallCandidate& c, const BallFinderParams& p);
bool ballIsOnGround(const Scene& scene, const BallCandidate& c, const BallFinderParams& p);
bool ballIsNear(const BallCandidate& c, const BallFinderParams& p);

BallPercept findBall(const Scene& scene, const BallFinderParams& params, VisionCounts& counts);

}  // namespace kelpie::vision
