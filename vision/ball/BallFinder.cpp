// SPDX-License-Identifier: Apache-2.0
#include "vision/ball/BallFinder.h"

#include <algorithm>
#include <cmath>

#include "robot/body/FieldDescription.h"
#include "robot/core/Maths.h"
#include "robot/core/ScratchVector.h"
#include "vision/ElevationDoubt.h"
#include "vision/Refusal.h"

namespace kelpie::vision {
namespace {

constexpr std::size_t kMaxCandidates = 6;
// A nearly straight edge is an arc of a ball that touches the camera: facts-2005 section 4.5
// check 2.
constexpr double kMaxRadius = 2000.0;  // px

// Range along the axis at which the centre is one ball radius above the ground.
double groundRange(const Scene& scene, const BallCandidate& c) {
  return (body::kBallRadius - scene.body.camera.position.z) / c.axis.z;
}

struct Range {
  double value = 0.0;
  double variance = 0.0;
};

// Most of its outline shows: a hidden one has a size of its own.
bool isWhole(const BallCandidate& c) {
  constexpr std::size_t kMaxEdges = 12;
  return c.cone.kept >= kMaxEdges;
}

// By size, and by the ground below when the ray descends; weighted by their variances unless they
// contradict each other.
Range fusedRange(const Scene& scene, const BallCandidate& c, const BallFinderParams& p) {
  constexpr double kMaxSds = 2.5;
  Range range{c.range, maths::square(c.range * p.edgeSd / c.cone.radius)};
  constexpr double kMinDescent = 0.02;
  if (c.axis.z > -kMinDescent) return range;
  const double ground = groundRange(scene, c);
  const double direction =
      maths::square(p.directionSd.rad()) + excessVariance(scene.body.camera, alongGround(c.axis));
  const double variance = direction * maths::square(ground / c.axis.z);
  // Both cannot be right: a whole outline has the ball's size, however the body leans. In seven
  // randomised worlds 12 of 18 false balls were real ones drawn to half of their distance.
  if (isWhole(c) &&
      std::fabs(ground - range.value) > kMaxSds * std::sqrt(range.variance + variance))
    return range;
  const double weight = range.variance / (range.variance + variance);
  return {range.value + weight * (ground - range.value), range.variance * (1.0 - weight)};
}

// Of its centre, when its outline is whole.
ElevationError elevationErrorOf(const Scene& scene, const BallCandidate& c,
                                const BallFinderParams& p) {
  constexpr double kShine = 2.0;       // of edgeSd: a highlight or a shadow moves the whole outline
  constexpr double kMaxDescent = 0.8;  // sine, up to which the arcsine is nearly straight
  const double below = (scene.body.camera.position.z - body::kBallRadius) / c.range;
  if (!isWhole(c) || below > kMaxDescent) return {};
  const double size = below * kShine * p.edgeSd / c.cone.radius;
  const double pixel = p.edgeSd / focalLength(scene);
  return {Angle::rad(ballElevationError(scene, c)), size * size + pixel * pixel};
}

BallPercept perceptOf(const Scene& scene, const BallCandidate& c, const BallFinderParams& p) {
  const Range range = fusedRange(scene, c, p);
  const Point3<Robot>& camera = scene.body.camera.position;
  const Point2<Robot> place{camera.x + range.value * c.axis.x, camera.y + range.value * c.axis.y};
  BallPercept ball;
  ball.present = true;
  ball.distance = place.norm();
  ball.heading = bearing(place);
  ball.elevation = Angle::rad(maths::asin(c.axis.z));
  ball.distanceVariance = std::max(range.variance, maths::square(p.minRangeShare * range.value));
  const double pixel = p.edgeSd / focalLength(scene);
  ball.headingVariance = maths::square(p.headingSd.rad()) + pixel * pixel;
  ball.elevationError = elevationErrorOf(scene, c, p);
  ball.centre = c.cone.centre;
  ball.radius = c.cone.radius;
  return ball;
}

bool checked(VisionCounts& counts, bool keep, Refusal reason) {
  if (!keep) refuse(counts, reason);
  return keep;
}

// What every ball passes, whatever hides or cuts it; all else is for the log odds.
bool mayBeBall(const Scene& scene, const BallCandidate& c, const BallFinderParams& p,
               VisionCounts& counts) {
  const auto check = [&counts](bool keep, Refusal reason) { return checked(counts, keep, reason); };
  return check(ballHasEdges(c, p), Refusal::ballFewEdges) &&
         check(ballIsRound(c, p), Refusal::ballPoorCircle) &&
         check(ballIsNear(c, p), Refusal::ballTooFar) &&
         check(ballIsBelowHorizon(scene, c, p), Refusal::ballAboveHorizon) &&
         check(ballIsInsideFieldEdge(scene, c, p), Refusal::ballAboveFieldEdge) &&
         check(ballIsOnGround(scene, c, p), Refusal::ballOffGround);
}

bool looksLikeBall(const BallFacts& facts, const BallFinderParams& p, VisionCounts& counts) {
  return checked(counts, ballIsOrange(facts, p), Refusal::ballFewOrange) &&
         checked(counts, ballHasNoOtherColour(facts, p), Refusal::ballOtherColour) &&
         checked(counts, ballHasFieldAround(facts, p), Refusal::ballNoField);
}

// Cheap forms of two checks, so that orange shirts do not use up the candidates.
bool mayLieOnField(const Scene& scene, const Blob& blob, const BallFinderParams& p,
                   VisionCounts& counts) {
  constexpr double kBoxSlack = 2.0;  // px, a lattice step that the blob's box may lack
  const PixelPoint lowest = scene.frame.toImage({blob.box.middle(), blob.box.bottom});
  if (belowHorizon(scene, lowest) < -p.maxAboveHorizon - rowSlack(scene)) {
    refuse(counts, Refusal::ballAboveHorizon);
    return false;
  }
  if (belowFieldEdge(scene, lowest) < -p.maxAboveFieldEdge - kBoxSlack) {
    refuse(counts, Refusal::ballAboveFieldEdge);
    return false;
  }
  return true;
}

// The largest orange blobs that may be on the field, largest first.
ScratchVector<const Blob*, kMaxCandidates> largestOrange(const Scene& scene,
                                                         const BallFinderParams& p,
                                                         VisionCounts& counts) {
  ScratchVector<const Blob*, kMaxCandidates> found;
  for (const Blob& blob : scene.blobs) {
    if (blob.colour != ColourClass::orange || !mayLieOnField(scene, blob, p, counts)) continue;
    const Blob* item = &blob;
    for (const Blob*& kept : found) {
      if (item->samples > kept->samples) std::swap(item, kept);
    }
    found.push_back(item);
  }
  return found;
}

constexpr double kSure = -4.0;  // log odds against a ball at which no other is looked at

struct Finder {
  const Scene& scene;
  const BallFinderParams& params;
  VisionCounts& counts;
  JudgedBalls& judged;
  JudgedBall best;

  bool isSure() const { return best.percept.present && best.logOddsAgainst <= kSure; }
  void judge(const BallCandidate& c) {
    if (!mayBeBall(scene, c, params, counts)) return;
    const BallFacts facts = ballFacts(scene, c);
    if (!looksLikeBall(facts, params, counts)) return;
    const JudgedBall ball{perceptOf(scene, c, params), facts, logOddsAgainst(facts)};
    judged.push_back(ball);
    if (ball.logOddsAgainst > params.maxLogOddsAgainst)
      refuse(counts, Refusal::ballUnlikely);
    else if (!best.percept.present || ball.logOddsAgainst < best.logOddsAgainst)
      best = ball;
  }
};

}  // namespace

bool ballHasEdges(const BallCandidate& c, const BallFinderParams& p) {
  return c.cone.valid && static_cast<double>(c.cone.kept) >= p.minEdgePoints;
}

bool ballIsRound(const BallCandidate& c, const BallFinderParams& p) {
  return c.cone.radius <= kMaxRadius &&
         c.cone.rms <= std::max(p.maxCircleError * c.cone.radius, p.minCircleError);
}

bool ballIsNear(const BallCandidate& c, const BallFinderParams& p) {
  return c.range <= p.maxDistance;
}

bool ballIsBelowHorizon(const Scene& scene, const BallCandidate& c, const BallFinderParams& p) {
  return belowHorizon(scene, c.cone.centre) >= -p.maxAboveHorizon - rowSlack(scene);
}

bool ballIsInsideFieldEdge(const Scene& scene, const BallCandidate& c, const BallFinderParams& p) {
  return belowFieldEdge(scene, c.cone.centre) + c.cone.radius >= -p.maxAboveFieldEdge;
}

bool ballIsOnGround(const Scene& scene, const BallCandidate& c, const BallFinderParams& p) {
  return std::fabs(ballHeightError(scene, c)) <= p.maxHeightError;
}

bool ballIsOrange(const BallFacts& facts, const BallFinderParams& p) {
  return facts.orange >= p.minOrangeShare;
}

bool ballHasNoOtherColour(const BallFacts& facts, const BallFinderParams& p) {
  return facts.otherColour <= p.maxOtherShare;
}

bool ballHasFieldAround(const BallFacts& facts, const BallFinderParams& p) {
  return facts.carpetAround >= p.minFieldShare;
}

BallPercept findBall(const Scene& scene, const BallFinderParams& params, VisionCounts& counts,
                     JudgedBalls& judged) {
  Finder finder{scene, params, counts, judged, {}};
  for (const Blob* blob : largestOrange(scene, params, counts)) {
    if (static_cast<double>(blob->samples) < params.minSamples) {
      refuse(counts, Refusal::ballTooSmall);
      continue;
    }
    finder.judge(ballFromMiddle(scene, *blob, params));
    if (finder.isSure()) break;
    finder.judge(ballFromFoot(scene, *blob, params));
  }
  return finder.best.percept;
}

}  // namespace kelpie::vision
