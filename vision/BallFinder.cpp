// SPDX-License-Identifier: Apache-2.0
#include "vision/BallFinder.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "robot/body/Camera.h"
#include "robot/body/FieldDescription.h"
#include "robot/core/Maths.h"
#include "vision/Refusal.h"
#include "vision/SpanWalk.h"

namespace kelpie::vision {
namespace {

constexpr int kSpokes = 16;
constexpr int kAround = 6;  // steps of 30 deg along the lower half
// Points outside the image count as carpet below this row: half the image.
constexpr double kLowerPart = 80.0;
constexpr std::size_t kMaxCandidates = 6;
// A nearly straight edge is an arc of a ball that touches the camera: facts-2005 section 4.5
// check 2.
constexpr double kLargestRadius = 2000.0;  // px

double turn(int step, int steps) { return 2.0 * maths::kPi * step / steps; }

// A highlight or a shadow may interrupt the orange for a sixth of the blob.
EdgePoints edgePoints(const Scene& scene, const Blob& blob) {
  const double size = std::max(blob.box.right - blob.box.left, blob.box.bottom - blob.box.top);
  const int holes = std::max(1, static_cast<int>(size / 6.0));
  EdgePoints points;
  for (int i = 0; i < kSpokes; ++i) {
    const auto direction = maths::sinCos(turn(i, kSpokes));
    const EdgeHit hit = walkToEdge(
        scene.sampler, {blob.centre, direction.cos, direction.sin, ColourClass::orange, holes});
    if (!hit.cut) points.push_back(hit.point);
  }
  return points;
}

Point3<Robot> inRobotFrame(const CameraPose& camera, Point3<Camera> c) {
  const auto& a = camera.axes;
  return {a[0] * c.x + a[1] * c.y + a[2] * c.z, a[3] * c.x + a[4] * c.y + a[5] * c.z,
          a[6] * c.x + a[7] * c.y + a[8] * c.z};
}

BallCandidate measured(const Scene& scene, const Blob& blob) {
  BallCandidate c;
  c.blob = &blob;
  c.cone = fitCone(edgePoints(scene, blob));
  if (!c.cone.valid) return c;
  c.axis = inRobotFrame(scene.body.camera, c.cone.axis);
  c.range = body::kBallRadius / c.cone.sinHalf;
  return c;
}

using ClassCounts = std::array<int, kColourClassCount + 1>;  // the last one counts all

// Classes inside the circle, on a grid of at most about 150 points.
ClassCounts countInside(const Scene& scene, const Cone& cone) {
  ClassCounts counts{};
  const double r = std::min(cone.radius, 200.0);
  const double step = std::max(1.0, r / 7.0);
  for (double y = -r; y <= r; y += step) {
    for (double x = -r; x <= r; x += step) {
      const PixelPoint p{cone.centre.x + x, cone.centre.y + y};
      if (x * x + y * y > r * r || !Sampler::usable(p)) continue;
      ++counts[index(scene.sampler.classAt(p))];
      ++counts[kColourClassCount];
    }
  }
  return counts;
}

int count(const ClassCounts& counts, ColourClass c) { return counts[index(c)]; }

// Range along the axis at which the centre is one ball radius above the ground.
double groundRange(const Scene& scene, const BallCandidate& c) {
  return (body::kBallRadius - scene.body.camera.position.z) / c.axis.z;
}

struct Range {
  double value = 0.0;
  double variance = 0.0;
};

// By size, and by the ground below when the ray descends; weighted by their variances.
Range fusedRange(const Scene& scene, const BallCandidate& c, const BallParams& p) {
  Range range{c.range, maths::square(c.range * p.edgeSd / c.cone.radius)};
  constexpr double kLeastDescent = 0.02;
  if (c.axis.z > -kLeastDescent) return range;
  const double ground = groundRange(scene, c);
  const double sd = ground * p.directionSd.rad() / -c.axis.z;
  const double weight = range.variance / (range.variance + sd * sd);
  return {range.value + weight * (ground - range.value), range.variance * (1.0 - weight)};
}

BallPercept perceptOf(const Scene& scene, const BallCandidate& c, const BallParams& p) {
  const Range range = fusedRange(scene, c, p);
  const Point3<Robot>& camera = scene.body.camera.position;
  const Point2<Robot> place{camera.x + range.value * c.axis.x, camera.y + range.value * c.axis.y};
  BallPercept ball;
  ball.present = true;
  ball.distance = place.norm();
  ball.heading = bearing(place);
  ball.elevation = Angle::rad(maths::asin(c.axis.z));
  ball.distanceVariance = range.variance;
  const double pixel = p.edgeSd / body::kFocalLength;
  ball.headingVariance = maths::square(p.headingSd.rad()) + pixel * pixel;
  ball.centre = c.cone.centre;
  ball.radius = c.cone.radius;
  return ball;
}

// Every check in order; the first that fails is counted.
bool accepted(const Scene& scene, const BallCandidate& c, const BallParams& p,
              VisionCounts& counts) {
  const auto check = [&counts](bool keep, Refusal reason) {
    if (!keep) refuse(counts, reason);
    return keep;
  };
  return check(ballHasEdges(c, p), Refusal::ballFewEdges) &&
         check(ballIsRound(c, p), Refusal::ballPoorCircle) &&
         check(ballIsNear(c, p), Refusal::ballTooFar) &&
         check(ballIsBelowHorizon(scene, c, p), Refusal::ballAboveHorizon) &&
         check(ballIsInsideFieldEdge(scene, c, p), Refusal::ballAboveFieldEdge) &&
         check(ballIsOnGround(scene, c, p), Refusal::ballOffGround) &&
         check(ballIsOrange(scene, c, p), Refusal::ballFewOrange) &&
         check(ballHasNoOtherColour(scene, c, p), Refusal::ballOtherColour) &&
         check(ballHasFieldAround(scene, c, p), Refusal::ballNoField);
}

// Cheap forms of two checks, so that orange shirts do not use up the candidates.
bool mayLieOnField(const Scene& scene, const Blob& blob, const BallParams& p,
                   VisionCounts& counts) {
  if (blob.box.bottom < horizonRow(scene, blob.centre.x) - p.maxAboveHorizon) {
    refuse(counts, Refusal::ballAboveHorizon);
    return false;
  }
  if (blob.box.bottom < fieldEdgeRow(scene, blob.centre.x) - p.maxAboveFieldEdge) {
    refuse(counts, Refusal::ballAboveFieldEdge);
    return false;
  }
  return true;
}

// The largest orange blobs that may be on the field, largest first.
FixedVector<const Blob*, kMaxCandidates> largestOrange(const Scene& scene, const BallParams& p,
                                                       VisionCounts& counts) {
  FixedVector<const Blob*, kMaxCandidates> found;
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

}  // namespace

bool ballHasEdges(const BallCandidate& c, const BallParams& p) {
  return c.cone.valid && static_cast<double>(c.cone.kept) >= p.minEdgePoints;
}

bool ballIsRound(const BallCandidate& c, const BallParams& p) {
  return c.cone.radius <= kLargestRadius &&
         c.cone.rms <= std::min(p.maxCircleError * c.cone.radius + 0.3, 4.0);
}

bool ballIsOrange(const Scene& scene, const BallCandidate& c, const BallParams& p) {
  const ClassCounts inside = countInside(scene, c.cone);
  return count(inside, ColourClass::orange) >= p.minOrangeShare * inside[kColourClassCount];
}

bool ballHasNoOtherColour(const Scene& scene, const BallCandidate& c, const BallParams& p) {
  const ClassCounts inside = countInside(scene, c.cone);
  const int other = count(inside, ColourClass::pink) + count(inside, ColourClass::yellow) +
                    count(inside, ColourClass::robotRed);
  return other <= p.maxOtherShare * inside[kColourClassCount];
}

bool ballIsBelowHorizon(const Scene& scene, const BallCandidate& c, const BallParams& p) {
  return c.cone.centre.y >= horizonRow(scene, c.cone.centre.x) - p.maxAboveHorizon;
}

bool ballIsInsideFieldEdge(const Scene& scene, const BallCandidate& c, const BallParams& p) {
  const double lowest = c.cone.centre.y + c.cone.radius;
  return lowest >= fieldEdgeRow(scene, c.cone.centre.x) - p.maxAboveFieldEdge;
}

bool ballHasFieldAround(const Scene& scene, const BallCandidate& c, const BallParams& p) {
  int field = 0;
  const double r = 1.3 * c.cone.radius + 2.0;
  for (int i = 0; i <= kAround; ++i) {
    const auto direction = maths::sinCos(maths::kPi * i / kAround);
    const PixelPoint at{c.cone.centre.x + r * direction.cos, c.cone.centre.y + r * direction.sin};
    const bool green =
        Sampler::usable(at) ? scene.sampler.classAt(at) == ColourClass::green : at.y > kLowerPart;
    field += green ? 1 : 0;
  }
  return field >= p.minFieldPoints;
}

// At the range that its size says, its centre must be a ball radius above the ground but for the
// error of the camera's direction and a tenth of error in size.
bool ballIsOnGround(const Scene& scene, const BallCandidate& c, const BallParams& p) {
  const double height = scene.body.camera.position.z + c.range * c.axis.z;
  const double allowed = 2.0 + c.range * (p.directionError.rad() + 0.1 * std::fabs(c.axis.z)) +
                         c.range * p.edgeSd / c.cone.radius * std::fabs(c.axis.z);
  return std::fabs(height - body::kBallRadius) <= allowed;
}

bool ballIsNear(const BallCandidate& c, const BallParams& p) { return c.range <= p.maxDistance; }

BallPercept findBall(const Scene& scene, const BallParams& params, VisionCounts& counts) {
  for (const Blob* blob : largestOrange(scene, params, counts)) {
    if (static_cast<double>(blob->samples) < params.minSamples) {
      refuse(counts, Refusal::ballTooSmall);
      continue;
    }
    const BallCandidate candidate = measured(scene, *blob);
    if (accepted(scene, candidate, params, counts)) return perceptOf(scene, candidate, params);
  }
  return {};
}

}  // namespace kelpie::vision
