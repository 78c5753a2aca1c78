// SPDX-License-Identifier: Apache-2.0
#include "vision/PinkFinder.h"

#include <cmath>

#include "robot/core/Maths.h"
#include "vision/Refusal.h"
#include "vision/Sight.h"

namespace kelpie::vision {
namespace {

constexpr double kUnknownSd = 1e3;  // cm, of a distance that nothing tells
constexpr double kBeside = 6.0;  // px from the patch's edge where the carpet behind is looked for

// The nearest of three columns: a patch that is askew stands on its lowest corner.
Foot footOf(const Scene& scene, ImageUp up, const PinkPatch& patch) {
  Foot best;
  for (const double share : {-0.8, 0.0, 0.8}) {
    const double aside = share * (share > 0.0 ? patch.extent.right : patch.extent.left);
    const PixelPoint from = moved(patch.centre, up, aside, 0.0);
    if (!Sampler::usable(from)) continue;
    const Foot foot = footBelow(scene, from, up, ColourClass::pink);
    if (foot.distance < best.distance) best = foot;
  }
  return best;
}

struct Estimate {
  double distance = 0.0;  // cm along the ground from the camera
  double variance = kUnknownSd * kUnknownSd;
};

Estimate fused(Estimate a, Estimate b) {
  const double weight = a.variance / (a.variance + b.variance);
  return {a.distance + weight * (b.distance - a.distance), a.variance * (1.0 - weight)};
}

Estimate byGround(const Scene& scene, const PinkPatch& patch, const PinkParams& p) {
  if (!p.onField || patch.foot.end != FootEnd::carpet) return {};
  const double above = scene.body.camera.position.z;
  const double d = patch.foot.distance;
  const double direction = maths::hypot(p.directionSd.rad(), p.edgeSd / body::kFocalLength);
  return {d, maths::square((d * d + above * above) / above * direction)};
}

Estimate bySize(const Scene& scene, const PinkPatch& patch, const PinkParams& p) {
  if (p.knownHeight <= 0.0) return {};
  const ImageUp up = imageUp(scene.body.camera);
  const Sight top = sightOf(scene.body.camera, moved(patch.centre, up, 0.0, patch.extent.upper));
  const Sight bottom =
      sightOf(scene.body.camera, moved(patch.centre, up, 0.0, -patch.extent.lower));
  if (top.slope - bottom.slope < 1e-3) return {};
  const double d = p.knownHeight / (top.slope - bottom.slope);
  return {d, maths::square(sizeSd(d, p.knownHeight, p.edgeSd))};
}

PinkPercept perceptOf(const Scene& scene, const PinkPatch& patch, const PinkParams& p) {
  const Estimate estimate = fused(byGround(scene, patch, p), bySize(scene, patch, p));
  const ImageUp up = imageUp(scene.body.camera);
  const double aside = 0.5 * (patch.extent.right - patch.extent.left);
  const double above = 0.5 * (patch.extent.upper - patch.extent.lower);
  const Sight sight = sightOf(scene.body.camera, moved(patch.centre, up, aside, above));
  const Point2<Robot> place = placeAt(scene.body.camera, sight, estimate.distance);
  PinkPercept pink;
  pink.distance = place.norm();
  pink.heading = bearing(place);
  pink.elevation = Angle::rad(maths::atan(sight.slope));
  pink.distanceVariance = estimate.variance;
  const double pixel = p.edgeSd / body::kFocalLength;
  pink.headingVariance = maths::square(p.headingSd.rad()) + pixel * pixel;
  pink.box = patch.box;
  return pink;
}

bool accepted(const Scene& scene, const PinkPatch& patch, const Landmarks& landmarks,
              const PinkParams& p, VisionCounts& counts) {
  const auto check = [&counts](bool keep, Refusal reason) {
    if (!keep) refuse(counts, reason);
    return keep;
  };
  return check(pinkIsDense(patch, p), Refusal::pinkTooSmall) &&
         check(pinkIsNoBeacon(patch, landmarks, p), Refusal::pinkIsBeacon) &&
         check(pinkIsLow(scene, patch, p), Refusal::pinkAboveHorizon) &&
         check(pinkIsInsideFieldEdge(patch, p), Refusal::pinkAboveFieldEdge) &&
         check(pinkStandsOnGround(patch, p), Refusal::pinkOffGround);
}

}  // namespace

PinkPatch measuredPink(const Scene& scene, const Blob& blob) {
  const ImageUp up = imageUp(scene.body.camera);
  PinkPatch patch;
  patch.samples = blob.samples;
  patch.box = imageBox(scene.level, blob.box);
  patch.centre = blob.centre;
  patch.extent = extentOf(scene.sampler, up, blob.centre, ColourClass::pink);
  patch.density =
      patch.samples * kLatticeStep * kLatticeStep / (patch.extent.width() * patch.extent.height());
  patch.foot = footOf(scene, up, patch);
  if (patch.foot.end == FootEnd::hidden) return patch;
  const PixelPoint lowest = moved(patch.centre, up, 0.0, -patch.extent.lower);
  patch.lift = heightAt(scene.body.camera, lowest, patch.foot.distance);
  patch.behind = carpetBehind(scene, up, patch.foot.pixel, patch.extent.width() + kBeside);
  return patch;
}

bool pinkIsLarge(const PinkPatch& patch, const PinkParams& p) {
  return patch.samples >= p.minSamples;
}

bool pinkIsDense(const PinkPatch& patch, const PinkParams& p) {
  return patch.extent.width() > p.minSize && patch.extent.height() > p.minSize &&
         patch.density >= p.minDensity;
}

bool pinkIsNoBeacon(const PinkPatch& patch, const Landmarks& landmarks, const PinkParams& p) {
  for (const LandmarkPercept& mark : landmarks) {
    const bool beside =
        patch.box.right < mark.box.left - p.maxNear || patch.box.left > mark.box.right + p.maxNear;
    const bool apart =
        patch.box.bottom < mark.box.top - p.maxNear || patch.box.top > mark.box.bottom + p.maxNear;
    if (mark.kind > LandmarkKind::goalYellow && !beside && !apart) return false;
  }
  return true;
}

bool pinkIsLow(const Scene& scene, const PinkPatch& patch, const PinkParams& p) {
  return sightOf(scene.body.camera, patch.centre).slope <= maths::tan(p.maxElevation.rad());
}

bool pinkIsInsideFieldEdge(const PinkPatch& patch, const PinkParams& p) {
  if (!p.onField || patch.behind >= p.minCarpetBehind) return true;
  return patch.behind <= kUnknownBehind && patch.foot.distance <= p.sureDistance;
}

bool pinkStandsOnGround(const PinkPatch& patch, const PinkParams& p) {
  if (!p.onField) return true;
  return patch.foot.end == FootEnd::carpet && patch.foot.distance <= p.maxDistance &&
         patch.lift <= p.maxLift;
}

void findPinkPatches(const Scene& scene, const Landmarks& landmarks, const PinkParams& params,
                     VisionCounts& counts, PinkPatches& patches) {
  if (!params.wanted) return;
  for (const Blob& blob : scene.blobs) {
    if (blob.colour != ColourClass::pink) continue;
    PinkPatch patch;
    patch.samples = blob.samples;
    if (!pinkIsLarge(patch, params)) {
      refuse(counts, Refusal::pinkTooSmall);
      continue;
    }
    patch = measuredPink(scene, blob);
    if (accepted(scene, patch, landmarks, params, counts) &&
        !patches.push_back(perceptOf(scene, patch, params)))
      refuse(counts, Refusal::bufferFull);
  }
}

}  // namespace kelpie::vision
