// SPDX-License-Identifier: Apache-2.0
// The ball: among the circles of the largest orange blobs (BallCandidate) the one that is most
// likely a ball. What every ball passes is checked; the rest are facts, judged as a whole
// (BallFacts). Distance from the outline's cone and from the ground below it, fused.
#pragma once

#include "vision/Scene.h"
#include "vision/ball/BallCandidate.h"
#include "vision/ball/BallFinderParams.h"
#include "vision/ball/JudgedBall.h"

namespace kelpie::vision {

// The checks, each alone so that each can be tested: true = keep.
bool ballHasEdges(const BallCandidate& c, const BallFinderParams& p);
bool ballIsRound(const BallCandidate& c, const BallFinderParams& p);
bool ballIsNear(const BallCandidate& c, const BallFinderParams& p);
bool ballIsBelowHorizon(const Scene& scene, const BallCandidate& c, const BallFinderParams& p);
bool ballIsInsideFieldEdge(const Scene& scene, const BallCandidate& c, const BallFinderParams& p);
bool ballIsOnGround(const Scene& scene, const BallCandidate& c, const BallFinderParams& p);
bool ballIsOrange(const BallFacts& facts, const BallFinderParams& p);
bool ballHasNoOtherColour(const BallFacts& facts, const BallFinderParams& p);
bool ballHasFieldAround(const BallFacts& facts, const BallFinderParams& p);

BallPercept findBall(const Scene& scene, const BallFinderParams& params, VisionCounts& counts,
                     JudgedBalls& judged);

}  // namespace kelpie::vision
