// SPDX-License-Identifier: Apache-2.0
#include "vision/ball/BallFinder.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "robot/body/Camera.h"
#include "robot/body/FieldDescription.h"
#include "robot/core/Maths.h"
#include "vision/Refusal.h"
#include "vision/pixels/SpanWalk.h"

namespace kelpie::vision {
namespace {

constexpr int kSpokes = 16;
constexpr int kFieldSteps = 6;  // of 30 deg along the lower half: seven points looked at for green
// Points outside the image count as carpet below this row: half the image.
constexpr double kCarpetFromRow = 80.0;
constexpr std::size_t kMaxCandidates = 6;
// A nearly straight edge is an arc of a ball that touches the camera: facts-2005 section 4.5
// check 2.
constexpr double kMaxRadius = 2000.0;  // px

double turn(int step, int steps) { return 2.0 * maths::kPi * step / steps; }

// Along spokes from a place inside the orange. A highlight or a shadow may interrupt the orange for
// a sixth of its size; what is farther away than `reach` is not the ball's outline.
EdgePoints edgePoints(const Scene& scene, PixelPoint from, double size, double reach) {
  const int holes = std::max(1, static_cast<int>(size / 6.0));
  EdgePoints points;
  for (int i = 0; i < kSpokes; ++i) {
    const auto direction = maths::sinCos(turn(i, kSpokes));
    const EdgeHit hit = walkToEdge(
        scene.sampler, {from, {direction.cos, direction.sin}, ColourClass::orange, holes});
    if (!hit.cut && hit.length <= reach) points.push_back(hit.point);
  }
  return points;
}

void measure(const Scene& scene, const EdgePoints& points, BallCandidate& c) {
  c.cone = fitCone(points);
  if (!c.cone.valid) return;
  c.axis = body::rayThrough(scene.body.camera, c.cone.centre);
  c.range = body::kBallRadius / c.cone.sinHalf;
}

BallCandidate fromMiddle(const Scene& scene, const Blob& blob) {
  BallCandidate c;
  c.blob = &blob;
  const double size = std::max(blob.box.width(), blob.box.height());
  measure(scene, edgePoints(scene, blob.centre, size, 1e3), c);
  return c;
}

std::uint16_t rootOf(const RunBuffer& runs, std::size_t run) {
  while (runs[run].parent != run) run = runs[run].parent;
  return runs[run].blob;
}

// The middle of the blob's lowest run.
std::optional<PixelPoint> lowestOf(const Scene& scene, const Blob& blob) {
  const auto index = static_cast<std::uint16_t>(&blob - scene.blobs.begin());
  for (std::size_t i = scene.runs.size(); i-- > 0;) {
    const Run& run = scene.runs[i];
    if (run.colour != ColourClass::orange || rootOf(scene.runs, i) != index) continue;
    return scene.frame.toImage(
        {scene.lattice.u(0.5 * (run.first + run.last)), scene.lattice.v(run.row)});
  }
  return std::nullopt;
}

// Where orange clothes touch the ball's image: a ball as large as one that stands where the patch
// ends below.
BallCandidate fromFoot(const Scene& scene, const Blob& blob) {
  BallCandidate c;
  c.blob = &blob;
  c.standsAlone = false;
  const auto lowest = lowestOf(scene, blob);
  if (!lowest) return c;
  const auto ground = body::groundPoint(scene.body.camera, *lowest);
  if (!ground) return c;
  const Point3<Robot>& eye = scene.body.camera.position;
  const double along = maths::hypot(ground->x - eye.x, ground->y - eye.y);
  const double radius =
      body::kFocalLength * body::kBallRadius / std::max(maths::hypot(along, eye.z), 10.0);
  const PixelPoint middle = moved(*lowest, scene.frame.up(), radius);
  if (!Sampler::usable(middle) || scene.sampler.classAt(middle) != ColourClass::orange) return c;
  measure(scene, edgePoints(scene, middle, 2.0 * radius, 1.7 * radius + 1.0), c);
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
Range fusedRange(const Scene& scene, const BallCandidate& c, const BallFinderParams& p) {
  Range range{c.range, maths::square(c.range * p.edgeSd / c.cone.radius)};
  constexpr double kMinDescent = 0.02;
  if (c.axis.z > -kMinDescent) return range;
  const double ground = groundRange(scene, c);
  const double sd = ground * p.directionSd.rad() / -c.axis.z;
  const double weight = range.variance / (range.variance + sd * sd);
  return {range.value + weight * (ground - range.value), range.variance * (1.0 - weight)};
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
  ball.distanceVariance = range.variance;
  const double pixel = p.edgeSd / body::kFocalLength;
  ball.headingVariance = maths::square(p.headingSd.rad()) + pixel * pixel;
  ball.centre = c.cone.centre;
  ball.radius = c.cone.radius;
  return ball;
}

// Every check in order; the first that fails is counted.
bool accepted(const Scene& scene, const BallCandidate& c, const BallFinderParams& p,
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
         check(ballFillsItsPatch(c, p), Refusal::ballPartOfPatch) &&
         check(ballStandsOnNoGoal(scene, c), Refusal::ballOnGoal) &&
         check(ballHasFieldAround(scene, c, p), Refusal::ballNoField);
}

// Cheap forms of two checks, so that orange shirts do not use up the candidates.
bool mayLieOnField(const Scene& scene, const Blob& blob, const BallFinderParams& p,
                   VisionCounts& counts) {
  const PixelPoint lowest = scene.frame.toImage({blob.box.middle(), blob.box.bottom});
  if (belowHorizon(scene, lowest) < -p.maxAboveHorizon) {
    refuse(counts, Refusal::ballAboveHorizon);
    return false;
  }
  if (belowFieldEdge(scene, lowest) < -p.maxAboveFieldEdge - 2.0) {
    refuse(counts, Refusal::ballAboveFieldEdge);
    return false;
  }
  return true;
}

// The largest orange blobs that may be on the field, largest first.
FixedVector<const Blob*, kMaxCandidates> largestOrange(const Scene& scene,
                                                       const BallFinderParams& p,
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

bool ballHasEdges(const BallCandidate& c, const BallFinderParams& p) {
  const double needed = c.standsAlone ? p.minEdgePoints : 0.55 * kSpokes;
  return c.cone.valid && static_cast<double>(c.cone.kept) >= needed;
}

bool ballIsRound(const BallCandidate& c, const BallFinderParams& p) {
  return c.cone.radius <= kMaxRadius &&
         c.cone.rms <= std::max(p.maxCircleError * c.cone.radius, p.minCircleError);
}

bool ballIsOrange(const Scene& scene, const BallCandidate& c, const BallFinderParams& p) {
  const ClassCounts inside = countInside(scene, c.cone);
  return count(inside, ColourClass::orange) >= p.minOrangeShare * inside[kColourClassCount];
}

bool ballHasNoOtherColour(const Scene& scene, const BallCandidate& c, const BallFinderParams& p) {
  const ClassCounts inside = countInside(scene, c.cone);
  const int other = count(inside, ColourClass::pink) + count(inside, ColourClass::yellow) +
                    count(inside, ColourClass::robotRed);
  return other <= p.maxOtherShare * inside[kColourClassCount];
}

// Orange beside the circle: it is cut out of something larger. A patch's lattice is coarse, hence
// the three samples on top.
bool ballFillsItsPatch(const BallCandidate& c, const BallFinderParams& p) {
  const double patch = static_cast<double>(c.blob->samples) * kLatticeStep * kLatticeStep;
  const double circle = maths::kPi * c.cone.radius * c.cone.radius;
  return !c.standsAlone || patch <= p.maxPatch * circle + 12.0;
}

// A ball hides its goal's foot: right behind its shadow is carpet. Orange over a goal's wall is
// seen over it, on its colour. The shadow of a large ball may look blue, so there the wall must
// show farther down.
bool ballStandsOnNoGoal(const Scene& scene, const BallCandidate& c) {
  constexpr double kLargeRadius = 8.0;  // px
  const LevelPoint middle = scene.frame.fromImage(c.cone.centre);
  const double start =
      c.cone.radius < kLargeRadius ? c.cone.radius + 2.5 : 1.6 * c.cone.radius + 2.0;
  for (const double further : {0.0, 0.7, 1.5}) {
    const double down = start + further * std::min(c.cone.radius, kLargeRadius);
    const PixelPoint at = scene.frame.toImage({middle.u, middle.v + down});
    if (!Sampler::usable(at)) return true;
    const ColourClass colour = scene.sampler.classAt(at);
    if (colour != ColourClass::blue && colour != ColourClass::yellow) return true;
  }
  return false;
}

bool ballIsBelowHorizon(const Scene& scene, const BallCandidate& c, const BallFinderParams& p) {
  return belowHorizon(scene, c.cone.centre) >= -p.maxAboveHorizon;
}

bool ballIsInsideFieldEdge(const Scene& scene, const BallCandidate& c, const BallFinderParams& p) {
  // A ball cut out of clothes must be surely inside.
  if (!c.standsAlone)
    return !scene.fieldEdges.empty() && belowFieldEdge(scene, c.cone.centre) + c.cone.radius >= 1.0;
  const double allowed = p.maxAboveFieldEdge + p.maxAboveShare * c.cone.radius;
  return belowFieldEdge(scene, c.cone.centre) + c.cone.radius >= -allowed;
}

bool ballHasFieldAround(const Scene& scene, const BallCandidate& c, const BallFinderParams& p) {
  int field = 0;
  const double r = 1.3 * c.cone.radius + 2.0;
  for (int i = 0; i <= kFieldSteps; ++i) {
    const auto direction = maths::sinCos(maths::kPi * i / kFieldSteps);
    const LevelPoint middle = scene.frame.fromImage(c.cone.centre);
    const PixelPoint at =
        scene.frame.toImage({middle.u + r * direction.cos, middle.v + r * direction.sin});
    const bool green = Sampler::usable(at) ? scene.sampler.classAt(at) == ColourClass::green
                                           : at.y > kCarpetFromRow;
    field += green ? 1 : 0;
  }
  return field >= (c.standsAlone ? p.minFieldPoints : p.minFieldPoints + 2.0);
}

// At the range that its size says, its centre must be a ball radius above the ground but for the
// error of the camera's direction and a tenth of error in size.
bool ballIsOnGround(const Scene& scene, const BallCandidate& c, const BallFinderParams& p) {
  const double height = scene.body.camera.position.z + c.range * c.axis.z;
  const double allowed = 2.0 + c.range * (p.directionError.rad() + 0.1 * std::fabs(c.axis.z)) +
                         c.range * p.edgeSd / c.cone.radius * std::fabs(c.axis.z);
  return std::fabs(height - body::kBallRadius) <= allowed;
}

bool ballIsNear(const BallCandidate& c, const BallFinderParams& p) {
  return c.range <= p.maxDistance;
}

BallPercept findBall(const Scene& scene, const BallFinderParams& params, VisionCounts& counts) {
  for (const Blob* blob : largestOrange(scene, params, counts)) {
    if (static_cast<double>(blob->samples) < params.minSamples) {
      refuse(counts, Refusal::ballTooSmall);
      continue;
    }
    for (const BallCandidate& candidate : {fromMiddle(scene, *blob), fromFoot(scene, *blob)}) {
      if (accepted(scene, candidate, params, counts)) return perceptOf(scene, candidate, params);
    }
  }
  return {};
}

}  // namespace kelpie::vision
