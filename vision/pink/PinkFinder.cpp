// SPDX-License-Identifier: Apache-2.0
#include "vision/pink/PinkFinder.h"

#include <cmath>

#include "robot/core/Maths.h"
#include "vision/ElevationDoubt.h"
#include "vision/Refusal.h"
#include "vision/pixels/GroundRay.h"

namespace kelpie::vision {
namespace {

// A patch that is askew stands on its lowest corner.
constexpr double kFootReach = 0.8;
// Where nothing tells the distance. The heading is that of a place so far away: cm off for walls.
constexpr double kUnknownDistance = 250.0;
constexpr double kUnknownSd = 1e3;
constexpr double kBesideMargin =
    6.0;  // px from the patch's edge where the carpet behind is looked for

struct Estimate {
  double distance = kUnknownDistance;  // cm along the ground from the camera
  double variance = kUnknownSd * kUnknownSd;
};

Estimate fused(Estimate a, Estimate b) {
  const double weight = a.variance / (a.variance + b.variance);
  return {a.distance + weight * (b.distance - a.distance), a.variance * (1.0 - weight)};
}

Estimate byGround(const Scene& scene, const PinkPatch& patch, const PinkFinderParams& p) {
  if (!p.onField || patch.foot.end != FootEnd::carpet) return {};
  const double d = patch.foot.distance;
  const CameraPose& camera = scene.body.camera;
  const double above = camera.position.z;
  const double direction =
      maths::hypot(maths::hypot(p.directionSd.rad(), p.edgeSd / focalLength(scene)),
                   elevationDoubt(camera, groundRayThrough(camera, patch.foot.pixel)).sd);
  return {d, maths::square((d * d + above * above) / above * direction)};
}

Estimate bySize(const Scene& scene, const PinkPatch& patch, const PinkFinderParams& p) {
  if (p.knownHeight <= 0.0) return {};
  const GroundRay top = groundRayThrough(scene.body.camera,
                                         scene.frame.beside(patch.centre, 0.0, patch.extent.upper));
  const GroundRay bottom = groundRayThrough(
      scene.body.camera, scene.frame.beside(patch.centre, 0.0, -patch.extent.lower));
  constexpr double kMinSlope = 1e-3;  // between its edges
  if (top.slope - bottom.slope < kMinSlope) return {};
  const double d = p.knownHeight / (top.slope - bottom.slope);
  return {d, maths::square(sizeSd(scene.body.camera, d, p.knownHeight, p.edgeSd))};
}

PinkPercept perceptOf(const Scene& scene, const PinkPatch& patch, const PinkFinderParams& p) {
  const Estimate estimate = fused(byGround(scene, patch, p), bySize(scene, patch, p));
  const double lateral = 0.5 * (patch.extent.right - patch.extent.left);
  const double above = 0.5 * (patch.extent.upper - patch.extent.lower);
  const GroundRay ray =
      groundRayThrough(scene.body.camera, scene.frame.beside(patch.centre, lateral, above));
  const Point2<Robot> place = placeAt(scene.body.camera, ray, estimate.distance);
  PinkPercept pink;
  pink.distance = place.norm();
  pink.heading = bearing(place);
  pink.elevation = Angle::rad(maths::atan(ray.slope));
  pink.distanceVariance = estimate.variance;
  const double pixel = p.edgeSd / focalLength(scene);
  pink.headingVariance = maths::square(p.headingSd.rad()) + pixel * pixel;
  pink.box = patch.box;
  return pink;
}

bool check(bool keep, Refusal reason, VisionCounts& counts) {
  if (!keep) refuse(counts, reason);
  return keep;
}

// What can be checked before its edges and its foot are looked for.
bool mayBePatch(const Scene& scene, const PinkPatch& patch, const Landmarks& landmarks,
                const PinkFinderParams& p, VisionCounts& counts) {
  return check(pinkIsLarge(patch, p), Refusal::pinkTooSmall, counts) &&
         check(pinkIsNoBeacon(patch, landmarks, p), Refusal::pinkIsBeacon, counts) &&
         check(pinkIsLow(scene, patch, p), Refusal::pinkAboveHorizon, counts);
}

bool accepted(const PinkPatch& patch, const PinkFinderParams& p, VisionCounts& counts) {
  return check(pinkIsDense(patch, p), Refusal::pinkTooSmall, counts) &&
         check(pinkStandsOnGround(patch, p), Refusal::pinkOffGround, counts) &&
         check(pinkIsInsideFieldEdge(patch, p), Refusal::pinkAboveFieldEdge, counts);
}

}  // namespace

PinkPatch pinkPatchOf(const HorizonFrame& frame, const Blob& blob) {
  PinkPatch patch;
  patch.samples = blob.samples;
  patch.box = imageBox(frame, blob.box);
  patch.centre = blob.centre;
  return patch;
}

void measurePink(const Scene& scene, PinkPatch& patch) {
  patch.extent = extentOf(scene.sampler, scene.frame, patch.centre, ColourClass::pink);
  patch.density =
      patch.samples * kLatticeStep * kLatticeStep / (patch.extent.width() * patch.extent.height());
  patch.foot = nearestFoot(scene, {patch.centre, -kFootReach * patch.extent.left,
                                   kFootReach * patch.extent.right, 3, ColourClass::pink});
  if (patch.foot.end == FootEnd::hidden) return;
  const PixelPoint lowest = scene.frame.beside(patch.centre, 0.0, -patch.extent.lower);
  patch.lift = heightAt(scene.body.camera, lowest, patch.foot.distance);
  patch.carpetBehind = carpetBehind(scene, patch.foot.pixel, patch.extent.width() + kBesideMargin);
}

bool pinkIsLarge(const PinkPatch& patch, const PinkFinderParams& p) {
  return patch.samples >= p.minSamples;
}

bool pinkIsDense(const PinkPatch& patch, const PinkFinderParams& p) {
  return patch.extent.width() > p.minSize && patch.extent.height() > p.minSize &&
         patch.density >= p.minDensity;
}

bool pinkIsNoBeacon(const PinkPatch& patch, const Landmarks& landmarks, const PinkFinderParams& p) {
  for (const LandmarkPercept& mark : landmarks) {
    const bool beside =
        patch.box.right < mark.box.left - p.maxNear || patch.box.left > mark.box.right + p.maxNear;
    const bool outside =
        patch.box.bottom < mark.box.top - p.maxNear || patch.box.top > mark.box.bottom + p.maxNear;
    if (mark.kind > LandmarkKind::goalYellow && !beside && !outside) return false;
  }
  return true;
}

bool pinkIsLow(const Scene& scene, const PinkPatch& patch, const PinkFinderParams& p) {
  return groundRayThrough(scene.body.camera, patch.centre).slope <=
         maths::tan(p.maxElevation.rad());
}

bool pinkIsInsideFieldEdge(const PinkPatch& patch, const PinkFinderParams& p) {
  if (!p.onField || patch.carpetBehind >= p.minCarpetBehind) return true;
  return patch.carpetBehind <= kUnknownBehind && patch.foot.distance <= p.sureDistance;
}

bool pinkStandsOnGround(const PinkPatch& patch, const PinkFinderParams& p) {
  if (!p.onField) return true;
  return patch.foot.end == FootEnd::carpet && patch.foot.distance <= p.maxDistance &&
         patch.lift <= p.maxLift;
}

void findPinkPatches(const Scene& scene, const Landmarks& landmarks, const PinkFinderParams& params,
                     VisionCounts& counts, PinkPatches& patches) {
  if (!params.wanted) return;
  for (const Blob& blob : scene.blobs) {
    if (blob.colour != ColourClass::pink) continue;
    PinkPatch patch = pinkPatchOf(scene.frame, blob);
    if (!mayBePatch(scene, patch, landmarks, params, counts)) continue;
    measurePink(scene, patch);
    if (accepted(patch, params, counts) && !patches.push_back(perceptOf(scene, patch, params)))
      refuse(counts, Refusal::bufferFull);
  }
}

}  // namespace kelpie::vision
