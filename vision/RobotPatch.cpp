// SPDX-License-Identifier: Apache-2.0
#include "vision/RobotPatch.h"

#include <algorithm>
#include <cmath>

#include "robot/core/Maths.h"
#include "vision/Sight.h"

namespace kelpie::vision {
namespace {

constexpr int kFootColumns = 6;  // to each side of a patch's centre
constexpr int kRingPoints = 16;
constexpr double kFarthestBehind = 8.0;  // px up to which carpet is looked for behind a robot
constexpr int kHoles = 2;                // px of another class inside a patch

// A pixel `right` and `above` of another one, as seen on an upright image.
PixelPoint moved(PixelPoint from, ImageUp up, double right, double above) {
  return {from.x - right * up.dy + above * up.dx, from.y + right * up.dx + above * up.dy};
}

double scaleAt(const Scene& scene, double distance, double height) {
  const double range = maths::hypot(distance, scene.body.camera.position.z - height);
  return body::kFocalLength / std::max(range, 5.0);
}

void measureExtent(const Scene& scene, ImageUp up, RobotPatch& patch) {
  const ColourClass colour =
      patch.team == TeamColour::red ? ColourClass::robotRed : ColourClass::robotBlue;
  const auto edge = [&](double dx, double dy) {
    return std::max(1.0, walkToEdge(scene.sampler, {patch.centre, dx, dy, colour, kHoles}).length);
  };
  patch.right = edge(-up.dy, up.dx);
  patch.left = edge(up.dy, -up.dx);
  patch.upper = edge(up.dx, up.dy);
  patch.lower = edge(-up.dx, -up.dy);
}

// In columns from the patch's middle down, `reach` px to both sides of its edges: under the trunk
// the far carpet shows, so the nearest foot is a leg's.
Foot nearestFoot(const Scene& scene, ImageUp up, const RobotPatch& patch, double reach) {
  Foot best;
  const double first = -patch.left - reach;
  const double last = patch.right + reach;
  for (int i = 0; i <= 2 * kFootColumns; ++i) {
    const double aside = first + (last - first) * i / (2 * kFootColumns);
    const PixelPoint from = moved(patch.centre, up, aside, 0.0);
    if (!Sampler::usable(from)) continue;
    const Foot foot = footBelow(scene, from, up);
    if (foot.distance < best.distance) best = foot;
  }
  return best;
}

// For a robot whose feet the image border cuts: by the height that patches have, and nearer than
// what the border shows of the ground.
double distanceByHeight(const Scene& scene, const RobotPatch& patch, const RobotParams& p) {
  const double farthest = patch.foot.distance;
  const double slope = sightOf(scene.body.camera, patch.centre).slope;
  const double below = scene.body.camera.position.z - p.patchHeight;
  if (slope > -0.02 || below < 1.0) return farthest;
  return std::min(-below / slope, farthest);
}

void measureDistance(const Scene& scene, ImageUp up, const RobotParams& p, RobotPatch& patch) {
  double reach = 0.0;
  // A second time with the legs beside the patch, whose place in the image the first one tells.
  for (int round = 0; round < 2; ++round) {
    patch.foot = nearestFoot(scene, up, patch, reach);
    const bool cut = patch.foot.end != FootEnd::carpet;
    patch.distance = cut ? distanceByHeight(scene, patch, p) : patch.foot.distance;
    patch.scale = scaleAt(scene, patch.distance, p.patchHeight);
    reach = p.reach * patch.scale;
  }
  patch.height = heightAt(scene.body.camera, patch.centre, patch.distance);
}

// White and grey of the shell, and colours that a uniform does not wear, on a ring round the patch.
void measureRing(const Scene& scene, ImageUp up, RobotPatch& patch) {
  int shell = 0;
  int seen = 0;
  for (int i = 0; i < kRingPoints; ++i) {
    const auto direction = maths::sinCos(2.0 * maths::kPi * i / kRingPoints);
    const double x = direction.cos * 1.2 * (direction.cos > 0.0 ? patch.right : patch.left);
    const double y = direction.sin * 1.2 * (direction.sin > 0.0 ? patch.upper : patch.lower);
    const PixelPoint at = moved(patch.centre, up, x + 2.0 * direction.cos, y + 2.0 * direction.sin);
    if (!Sampler::usable(at)) continue;
    const ColourClass c = scene.sampler.classAt(at);
    shell += c == ColourClass::white || c == ColourClass::grey ? 1 : 0;
    ++seen;
  }
  patch.shell = seen > 0 ? static_cast<double>(shell) / seen : 0.0;
}

// Of the lattice inside the box: red clothes are pink and orange by turns, dark ones blue.
double ownShare(const Scene& scene, const RobotPatch& patch) {
  int own = 0;
  int other = 0;
  const int left = std::max(kLatticeLeft, static_cast<int>(patch.box.left) / 2 * 2);
  const int top = std::max(kLatticeTop, static_cast<int>(patch.box.top) / 2 * 2);
  const int step = kLatticeStep * (1 + static_cast<int>(patch.box.right - patch.box.left) / 24);
  for (int py = top; py < patch.box.bottom && py < kUsableBottom; py += step) {
    for (int px = left; px < patch.box.right && px < kUsableRight; px += step) {
      const ColourClass c = scene.sampler.classAt(px, py);
      const bool red = c == ColourClass::robotRed;
      const bool blue = c == ColourClass::robotBlue;
      if (patch.team == TeamColour::red ? red : blue) ++own;
      if (patch.team == TeamColour::red && (c == ColourClass::pink || c == ColourClass::orange))
        ++other;
      if (patch.team == TeamColour::blue && (c == ColourClass::blue || c == ColourClass::black))
        ++other;
    }
  }
  return own > 0 ? static_cast<double>(own) / (own + other) : 0.0;
}

// How far the carpet goes on above a level line through the foot, at one place beside it: negative
// where it ends below. A white line does not end it.
double carpetAbove(const Scene& scene, ImageUp up, PixelPoint foot, double aside) {
  constexpr int kWidestLine = 4;
  int gap = 0;
  double last = -kFarthestBehind;
  for (double above = last; above <= kFarthestBehind && gap <= kWidestLine; above += 1.0) {
    const PixelPoint at = moved(foot, up, aside, above);
    if (!Sampler::usable(at)) return kFarthestBehind;
    const bool green = scene.sampler.classAt(at) == ColourClass::green;
    gap = green ? 0 : gap + 1;
    if (green) last = above;
  }
  return last;
}

// On carpet that goes on behind it a robot has green above the level of its foot; clothes beyond
// the carpet seem to stand on its very end. Both sides together, because that end may be askew; the
// best of three pairs, because another thing may stand beside the robot.
double carpetBehind(const Scene& scene, ImageUp up, const RobotPatch& patch) {
  double best = -kFarthestBehind;
  for (const double aside : {16.0, 22.0, 28.0}) {
    const double px = aside * patch.scale;
    const double both = carpetAbove(scene, up, patch.foot.pixel, px) +
                        carpetAbove(scene, up, patch.foot.pixel, -px);
    best = std::max(best, 0.5 * both);
  }
  return best;
}

}  // namespace

RobotPatch patchOf(const Blob& blob) {
  RobotPatch patch;
  patch.team = blob.colour == ColourClass::robotRed ? TeamColour::red : TeamColour::blue;
  patch.samples = blob.samples;
  patch.box = blob.box;
  patch.centre = blob.centre;
  return patch;
}

void measurePatch(const Scene& scene, const RobotParams& p, RobotPatch& patch) {
  const ImageUp up = imageUp(scene.body.camera);
  measureExtent(scene, up, patch);
  measureDistance(scene, up, p, patch);
  measureRing(scene, up, patch);
  patch.own = ownShare(scene, patch);
  patch.behind = carpetBehind(scene, up, patch);
}

bool robotPatchIsLarge(const RobotPatch& patch, const RobotParams& p) {
  return patch.samples >= p.minSamples;
}

bool robotPatchIsLow(const Scene& scene, const RobotPatch& patch, const RobotParams& p) {
  return sightOf(scene.body.camera, patch.centre).slope <= maths::tan(p.maxElevation.rad());
}

bool robotPatchHasSize(const RobotPatch& patch, const RobotParams& p) {
  return patch.left + patch.right <= p.maxPatchWidth * patch.scale + 2.0 &&
         patch.upper + patch.lower <= p.maxPatchHeight * patch.scale + 2.0;
}

bool robotPatchIsPure(const RobotPatch& patch, const RobotParams& p) {
  return patch.own >= p.minOwnShare;
}

bool robotHasShell(const RobotPatch& patch, const RobotParams& p) {
  return patch.shell >= p.minShell;
}

bool robotIsInsideFieldEdge(const Scene& scene, const RobotPatch& patch, const RobotParams& p) {
  if (patch.foot.end != FootEnd::carpet) return true;
  if (patch.behind < p.minCarpetBehind) return false;
  const FieldEdgePercept& e = scene.fieldEdge;
  const double rise = (e.atRight - e.atLeft) / kImageWidth;
  const double below = patch.foot.pixel.y - fieldEdgeRow(scene, patch.foot.pixel.x);
  return below >= p.minInsideFieldEdge * std::sqrt(1.0 + rise * rise);
}

bool robotStandsOnGround(const RobotPatch& patch, const RobotParams& p) {
  if (patch.foot.end == FootEnd::hidden) return false;
  return patch.height >= p.minHeight && patch.height <= p.maxHeight;
}

bool robotIsNear(const RobotPatch& patch, const RobotParams& p) {
  const bool cut = patch.foot.end != FootEnd::carpet;
  return patch.foot.distance <= (cut ? p.maxCutDistance : p.maxDistance);
}

}  // namespace kelpie::vision
