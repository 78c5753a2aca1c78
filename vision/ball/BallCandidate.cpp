// SPDX-License-Identifier: Apache-2.0
#include "vision/ball/BallCandidate.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "robot/body/Camera.h"
#include "robot/body/FieldDescription.h"
#include "robot/core/Maths.h"
#include "vision/ElevationDoubt.h"
#include "vision/pixels/SpanWalk.h"

namespace kelpie::vision {
namespace {

constexpr int kSpokes = 16;

// px, without what this camera adds: the measured one is r + edgeBias - blur^2 / (2 r).
double trueRadius(double measured, const BallFinderParams& p) {
  constexpr double kMinRadius = 0.5;
  const double half = 0.5 * (measured - p.edgeBias);
  return std::max(kMinRadius, half + std::sqrt(half * half + 0.5 * maths::square(p.blur)));
}

// Along spokes from a place inside the orange. A highlight or a shadow may interrupt the orange;
// what is farther away than `reach` is not the ball's outline.
void measure(const Scene& scene, PixelPoint from, double size, double reach,
             const BallFinderParams& p, BallCandidate& c) {
  constexpr double kSizePerHole = 6.0;  // it may be a sixth of the ball's size
  const int holes = std::max(1, static_cast<int>(size / kSizePerHole));
  EdgePoints points;
  for (int i = 0; i < kSpokes; ++i) {
    const auto direction = maths::sinCos(2.0 * maths::kPi * i / kSpokes);
    const EdgeHit hit = walkToEdge(
        scene.sampler, {from, {direction.cos, direction.sin}, ColourClass::orange, holes});
    c.cut += hit.cut ? 1U : 0U;
    if (!hit.cut && hit.length <= reach) points.push_back(hit.point);
  }
  c.cone = fitCone(points, scene.body.camera.lens);
  if (!c.cone.valid) return;
  c.axis = body::rayThrough(scene.body.camera, c.cone.centre);
  c.range = body::kBallRadius / c.cone.sinHalf * (c.cone.radius / trueRadius(c.cone.radius, p));
}

// Share by which the range by size may be wrong.
double sizeTolerance(const BallCandidate& c) {
  constexpr double kSize = 0.1;
  constexpr double kRadius = 0.3;  // px
  return kSize + kRadius / c.cone.radius;
}

ElevationDoubt doubtOf(const Scene& scene, const BallCandidate& c, double settledSd) {
  return elevationDoubt(scene.body.camera, alongGround(c.axis), settledSd);
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

}  // namespace

BallCandidate ballFromMiddle(const Scene& scene, const Blob& blob, const BallFinderParams& p) {
  BallCandidate c;
  c.blob = &blob;
  const double size = std::max(blob.box.width(), blob.box.height());
  constexpr double kAnyReach = 1e3;  // px, more than an image's diagonal
  measure(scene, blob.centre, size, kAnyReach, p, c);
  return c;
}

BallCandidate ballFromFoot(const Scene& scene, const Blob& blob, const BallFinderParams& p) {
  constexpr double kMinRange = 10.0;  // cm
  constexpr double kMaxReach = 1.7;   // radii, and a pixel: beyond, another thing's edge
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
      focalLength(scene) * body::kBallRadius / std::max(maths::hypot(along, eye.z), kMinRange);
  const PixelPoint middle = moved(*lowest, scene.frame.up(), radius);
  if (!Sampler::usable(middle) || scene.sampler.classAt(middle) != ColourClass::orange) return c;
  measure(scene, middle, 2.0 * radius, kMaxReach * radius + 1.0, p, c);
  return c;
}

double ballHeightError(const Scene& scene, const BallCandidate& c) {
  constexpr double kHeight = 2.0;      // cm, at any range
  constexpr double kDirection = 0.03;  // rad, of the camera: 1.7 deg
  const double height = scene.body.camera.position.z + c.range * c.axis.z;
  const double descent = std::fabs(c.axis.z);
  const double direction = kDirection * doubtOf(scene, c, kSettledSd).spread;
  const double allowed = kHeight + c.range * (direction + sizeTolerance(c) * descent);
  return (height - body::kBallRadius) / allowed;
}

double ballElevationError(const Scene& scene, const BallCandidate& c) {
  const double below = (scene.body.camera.position.z - body::kBallRadius) / c.range;
  return maths::asin(c.axis.z) + maths::asin(maths::clamp(below, -1.0, 1.0));
}

double settledBallElevationError(const Scene& scene, const BallCandidate& c) {
  const double sd = maths::hypot(kSettledSd, sizeTolerance(c) * c.axis.z);
  return ballElevationError(scene, c) / doubtOf(scene, c, sd).spread;
}

}  // namespace kelpie::vision
