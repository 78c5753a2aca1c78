// SPDX-License-Identifier: Apache-2.0
#include "vision/robot/RobotPatch.h"

#include <algorithm>
#include <cmath>

#include "robot/core/Maths.h"
#include "vision/ElevationDoubt.h"
#include "vision/pixels/GroundRay.h"

namespace kelpie::vision {
namespace {

constexpr int kFirstColumns = 3;
constexpr int kFootColumns = 11;
constexpr int kRingPoints = 16;
constexpr double kSizeSlack = 2.0;  // px, by which a patch may seem too large
constexpr double kBeside = 20.0;    // cm from a foot: beyond the robot's other legs, 15 cm away

ColourClass colourOf(TeamColour team) {
  return team == TeamColour::red ? ColourClass::robotRed : ColourClass::robotBlue;
}

double scaleAt(const Scene& scene, double distance, double height) {
  constexpr double kMinRange = 5.0;  // cm
  const double range = maths::hypot(distance, scene.body.camera.position.z - height);
  return focalLength(scene) / std::max(range, kMinRange);
}

// For a robot whose feet the image border cuts: by the height above the ground and the size that
// patches have, and nearer than what the border shows of the ground.
double distanceWithoutFoot(const Scene& scene, const RobotPatch& patch,
                           const RobotFinderParams& p) {
  constexpr double kMinDescent = 0.02;  // slope; a flatter ray tells no distance
  const double bySize =
      focalLength(scene) * p.patchSize / (patch.extent.upper + patch.extent.lower);
  const double farthest = std::min(patch.foot.distance, bySize);
  const double slope = groundRayThrough(scene.body.camera, patch.centre).slope;
  const double below = scene.body.camera.position.z - p.patchHeight;
  if (slope > -kMinDescent || below < 1.0) return farthest;
  return std::min(-below / slope, farthest);
}

void measureDistance(const Scene& scene, const RobotFinderParams& p, RobotPatch& patch) {
  // Under the trunk the far carpet shows, so the nearest foot is a leg's; legs are beside the patch
  // too, and how far in the image the first round tells.
  double reach = 0.0;
  for (const int columns : {kFirstColumns, kFootColumns}) {
    const Foot foot =
        nearestFoot(scene, {patch.centre, -patch.extent.left - reach, patch.extent.right + reach,
                            columns, colourOf(patch.team), patch.foot.distance});
    if (foot.distance < patch.foot.distance) patch.foot = foot;
    const bool cut = patch.foot.end != FootEnd::carpet;
    patch.distance = cut ? distanceWithoutFoot(scene, patch, p) : patch.foot.distance;
    patch.scale = scaleAt(scene, patch.distance, p.patchHeight);
    reach = p.reach * patch.scale;
  }
}

// Foot and patch are seen as much too high or too low by a badly known tilt. The angle between them
// tells the distance too, by the height that patches have: both are weighed by what is not known.
void weighDistance(const Scene& scene, const RobotFinderParams& p, RobotPatch& patch) {
  constexpr double kHeightShare = 0.25;  // sd of the height of patches, 8 to 22 cm
  const CameraPose& camera = scene.body.camera;
  const GroundRay ray = groundRayThrough(camera, patch.centre);
  const double sd = elevationDoubt(camera, ray).sd;
  if (sd == 0.0 || patch.foot.end == FootEnd::hidden) return;
  const double above = std::max(camera.position.z, 1.0);
  const double rise = ray.slope - groundRayThrough(camera, patch.foot.pixel).slope;
  if (patch.foot.end == FootEnd::carpet && rise > 0.0) {
    // As inverse distances, in which the angles are linear.
    const double bySize = rise / p.patchHeight;
    const double variance = maths::square(kHeightShare * bySize);
    const double weight = variance / (variance + maths::square(sd / above));
    patch.distance = 1.0 / (bySize + weight * (1.0 / patch.distance - bySize));
    patch.scale = scaleAt(scene, patch.distance, p.patchHeight);
  }
  patch.distanceSd = sd * maths::square(patch.distance) / above;
  patch.heightSd = sd * patch.distance * p.patchHeight / above;
}

// So many times nearer or farther than it seems a robot may be by the tilt alone.
double distanceRatio(const RobotPatch& patch) {
  return 1.0 + patch.distanceSd / std::max(patch.distance, 1.0);
}

bool heightMayBe(const RobotPatch& patch, const RobotFinderParams& p) {
  const double slack = kSlackSds * patch.heightSd;
  return patch.height >= p.minHeight - slack && patch.height <= p.maxHeight + slack;
}

bool isOwn(ColourClass c, TeamColour team) { return c == colourOf(team); }

// What no part of a robot of that team wears. In bad light a blue patch is black or goal blue here
// and there.
bool isForeign(ColourClass c, TeamColour team) {
  if (c == ColourClass::orange || c == ColourClass::yellow || c == ColourClass::pink) return true;
  if (team == TeamColour::blue) return c == ColourClass::robotRed;
  return c == ColourClass::blue || c == ColourClass::robotBlue || c == ColourClass::black;
}

// White and grey of the shell, and colours that a uniform does not wear, on a ring round the patch.
void measureRing(const Scene& scene, RobotPatch& patch) {
  constexpr double kRing = 1.2;     // of the extent, and so many
  constexpr double kOutside = 2.0;  // px farther, past the mixed ones
  int shell = 0;
  int foreign = 0;
  int seen = 0;
  for (int i = 0; i < kRingPoints; ++i) {
    const auto direction = maths::sinCos(2.0 * maths::kPi * i / kRingPoints);
    const double x =
        direction.cos * kRing * (direction.cos > 0.0 ? patch.extent.right : patch.extent.left);
    const double y =
        direction.sin * kRing * (direction.sin > 0.0 ? patch.extent.upper : patch.extent.lower);
    const PixelPoint at = scene.frame.beside(patch.centre, x + kOutside * direction.cos,
                                             y + kOutside * direction.sin);
    if (!Sampler::usable(at)) continue;
    const ColourClass c = scene.sampler.classAt(at);
    shell += c == ColourClass::white || c == ColourClass::grey ? 1 : 0;
    foreign += isForeign(c, patch.team) ? 1 : 0;
    ++seen;
  }
  patch.shellShare = seen > 0 ? static_cast<double>(shell) / seen : 0.0;
  patch.foreignShare = seen > 0 ? static_cast<double>(foreign) / seen : 0.0;
}

// Red clothes are pink and orange by turns, dark ones blue.
double ownShare(const Scene& scene, const RobotPatch& patch) {
  constexpr double kSamplesWide = 24.0;  // px for each lattice step that the samples are apart
  int own = 0;
  int foreign = 0;
  const double step = kLatticeStep * (1.0 + std::floor(patch.levelBox.width() / kSamplesWide));
  for (double v = patch.levelBox.top + 0.5; v < patch.levelBox.bottom; v += step) {
    for (double u = patch.levelBox.left + 0.5; u < patch.levelBox.right; u += step) {
      const PixelPoint at = scene.frame.toImage({u, v});
      if (!Sampler::usable(at)) continue;
      const ColourClass c = scene.sampler.classAt(at);
      own += isOwn(c, patch.team) ? 1 : 0;
      foreign += isForeign(c, patch.team) ? 1 : 0;
    }
  }
  return own > 0 ? static_cast<double>(own) / (own + foreign) : 0.0;
}

// Class of the mean colour inside the patch: noise makes specks of a uniform's colour on clothes,
// but not their mean.
bool meanIsOwn(const Scene& scene, const RobotPatch& patch) {
  constexpr int kGrid = 2;
  constexpr double kInside = 0.35;  // of the extent, for each of two steps from the centre
  int y = 0;
  int cr = 0;
  int cb = 0;
  int count = 0;
  for (int i = -kGrid; i <= kGrid; ++i) {
    for (int j = -kGrid; j <= kGrid; ++j) {
      const double right = kInside * i * (i > 0 ? patch.extent.right : patch.extent.left);
      const double above = kInside * j * (j > 0 ? patch.extent.upper : patch.extent.lower);
      const PixelPoint at = scene.frame.beside(patch.centre, right, above);
      if (!Sampler::usable(at)) continue;
      const Yuv c = scene.sampler.corrected(Sampler::pixelOf(at.x), Sampler::pixelOf(at.y));
      y += c.y;
      cr += c.cr;
      cb += c.cb;
      ++count;
    }
  }
  if (count == 0) return false;
  const auto mean = [count](int sum) { return static_cast<std::uint8_t>(sum / count); };
  return isOwn(scene.sampler.classOf({mean(y), mean(cr), mean(cb)}), patch.team);
}

// Along the ground from the foot to the field edge above it in the image; kNoDistance where no edge
// or only the horizon is above.
double carpetBeyond(const Scene& scene, const Foot& foot) {
  if (scene.fieldEdges.empty()) return kNoDistance;
  const PixelPoint edge = scene.frame.beside(foot.pixel, 0.0, belowFieldEdge(scene, foot.pixel));
  const auto distance = groundDistance(scene.body.camera, edge);
  return distance ? *distance - foot.distance : kNoDistance;
}

}  // namespace

RobotPatch patchOf(const Scene& scene, const Blob& blob) {
  RobotPatch patch;
  patch.team = blob.colour == ColourClass::robotRed ? TeamColour::red : TeamColour::blue;
  patch.samples = blob.samples;
  patch.levelBox = blob.box;
  patch.box = imageBox(scene.frame, blob.box);
  patch.centre = blob.centre;
  patch.ownShare = ownShare(scene, patch);
  return patch;
}

void measurePatch(const Scene& scene, const RobotFinderParams& p, RobotPatch& patch) {
  patch.extent = extentOf(scene.sampler, scene.frame, patch.centre, colourOf(patch.team));
  measureDistance(scene, p, patch);
  weighDistance(scene, p, patch);
  patch.height = heightAt(scene.body.camera, patch.centre, patch.distance);
}

void measureSurroundings(const Scene& scene, RobotPatch& patch) {
  measureRing(scene, patch);
  patch.meanIsOwn = meanIsOwn(scene, patch);
  patch.carpetBehind = carpetBehind(scene, patch.foot.pixel, kBeside * patch.scale);
  patch.carpetBeyond = carpetBeyond(scene, patch.foot);
}

RobotFacts robotFacts(const Scene& scene, const RobotPatch& patch) {
  constexpr double kTrunkHeight = 14.0;  // cm, of most patches' middle
  constexpr double kFarBeyond = 300.0;   // cm; without an edge in view as well
  constexpr double kFarInside = 40.0;    // px; the same
  constexpr double kHeightSd = 3.0;      // cm, by which heights of patches differ
  RobotFacts facts;
  facts.ownShare = patch.ownShare;
  facts.meanIsOwn = patch.meanIsOwn ? 1.0 : 0.0;
  facts.patchWidth = patch.extent.width() / patch.scale;
  facts.patchHeight = patch.extent.height() / patch.scale;
  facts.heightError =
      std::fabs(patch.height - kTrunkHeight) / maths::hypot(1.0, patch.heightSd / kHeightSd);
  facts.carpetBeyond = std::min(patch.carpetBeyond, kFarBeyond);
  facts.footBelowEdge = std::min(belowFieldEdge(scene, patch.foot.pixel), kFarInside);
  facts.footCut = patch.foot.end == FootEnd::carpet ? 0.0 : 1.0;
  return facts;
}

bool robotPatchIsLow(const Scene& scene, const RobotPatch& patch, const RobotFinderParams& p) {
  return groundRayThrough(scene.body.camera, patch.centre).slope <=
         maths::tan(p.maxElevation.rad());
}

bool robotPatchHasSize(const RobotPatch& patch, const RobotFinderParams& p) {
  // Without feet the size is all that tells the distance, so the whole patch must show.
  const bool cut = patch.foot.end != FootEnd::carpet;
  const double nearest = patch.scale * distanceRatio(patch);
  const double farthest = patch.scale / distanceRatio(patch);
  if (cut && patch.extent.height() + 1.0 < p.minCutPatch * farthest) return false;
  return patch.extent.width() + 1.0 >= p.minPatchWidth * farthest &&
         patch.extent.width() <= p.maxPatchWidth * nearest + kSizeSlack &&
         patch.extent.height() <= p.maxPatchHeight * nearest + kSizeSlack &&
         patch.extent.height() <= p.maxTall * patch.extent.width() + kSizeSlack;
}

// In speckled clothes the way from the centre to the edge ends far too soon for so many samples.
bool robotPatchIsSolid(const RobotPatch& patch) {
  constexpr double kMaxShareOfExtent = 3.0;
  const double pixels = patch.samples * kLatticeStep * kLatticeStep;
  return pixels <= kMaxShareOfExtent * patch.extent.width() * patch.extent.height();
}

// Before carpet that goes on behind it, other colours near a patch are the background's.
bool robotPatchIsPure(const RobotPatch& patch, const RobotFinderParams& p) {
  if (patch.carpetBehind >= p.sureCarpetBehind) return true;
  return patch.meanIsOwn && robotPatchIsSolid(patch) &&
         patch.foreignShare <= p.doubtfulForeignShare;
}

bool robotPatchIsClean(const RobotPatch& patch, const RobotFinderParams& p) {
  return patch.meanIsOwn && patch.ownShare >= p.cleanOwnShare &&
         patch.foreignShare <= p.cleanForeignShare;
}

bool robotPatchTellsDistance(const RobotPatch& patch, const RobotFinderParams& p) {
  return patch.foot.end != FootEnd::hidden && patch.samples >= p.partSamples &&
         heightMayBe(patch, p) &&
         patch.extent.width() <= p.maxPatchWidth * patch.scale + kSizeSlack;
}

bool robotHasShell(const RobotPatch& patch, const RobotFinderParams& p) {
  return patch.shellShare >= (patch.samples <= p.fewSamples ? p.minShellOfFew : p.minShell);
}

// Near robots show large patches; so small ones are shade on things beside the carpet.
bool robotIsNoSpeck(const RobotPatch& patch, const RobotFinderParams& p) {
  return patch.samples > p.fewSamples || patch.distance >= p.maxSpeckDistance ||
         patch.carpetBehind >= p.speckCarpetBehind;
}

// The border that is said to cut the feet shows ground only little farther than they are.
bool robotFeetMayBeCut(const RobotPatch& patch, const RobotFinderParams& p) {
  return patch.foot.end == FootEnd::carpet ||
         patch.foot.distance <= p.maxBorderRatio * patch.distance;
}

bool robotIsInsideFieldEdge(const Scene& scene, const RobotPatch& patch,
                            const RobotFinderParams& p) {
  if (patch.foot.end == FootEnd::carpet && patch.carpetBeyond < p.minCarpetBeyond) return false;
  const bool unknown = patch.carpetBehind <= kUnknownBehind;
  if (unknown && patch.foot.end == FootEnd::carpet && scene.fieldEdges.empty())
    return robotPatchIsClean(patch, p);
  return belowFieldEdge(scene, patch.foot.pixel) >= p.minInsideFieldEdge;
}

bool robotStandsOnGround(const RobotPatch& patch, const RobotFinderParams& p) {
  if (patch.foot.end == FootEnd::hidden) return false;
  return heightMayBe(patch, p);
}

bool robotPatchHasColour(const RobotPatch& patch, const RobotFinderParams& p) {
  return patch.ownShare >= p.minOwnShare;
}

bool robotIsNear(const RobotPatch& patch, const RobotFinderParams& p) {
  if (patch.foot.end == FootEnd::carpet)
    return patch.foot.distance <= p.maxDistance + patch.distanceSd;
  const bool sure = patch.carpetBehind >= p.sureCarpetBehind || robotPatchIsClean(patch, p);
  return patch.distance <= (sure ? p.maxCutDistance : p.maxDoubtfulCutDistance);
}

}  // namespace kelpie::vision
