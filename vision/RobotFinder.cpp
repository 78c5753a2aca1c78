// SPDX-License-Identifier: Apache-2.0
#include "vision/RobotFinder.h"

#include <algorithm>
#include <cmath>

#include "robot/core/Maths.h"
#include "vision/Refusal.h"
#include "vision/Sight.h"

namespace kelpie::vision {
namespace {

constexpr std::size_t kMaxPatches = 16;
constexpr int kFootColumns = 6;  // to each side of a patch's centre
constexpr int kShellPoints = 16;
using Patches = FixedVector<RobotPatch, kMaxPatches>;

double widthOf(const PixelBox& box) { return box.right - box.left; }
double heightOf(const PixelBox& box) { return box.bottom - box.top; }

double scaleAt(const Scene& scene, double distance, double height) {
  const double range = maths::hypot(distance, scene.body.camera.position.z - height);
  return body::kFocalLength / std::max(range, 5.0);
}

// Columns from the patch's middle down, `reach` px to both sides: under the trunk the far carpet
// shows, so the nearest foot is a leg's.
Foot nearestFoot(const Scene& scene, const RobotPatch& patch, double reach) {
  const ImageUp up = imageUp(scene.body.camera);
  Foot best;
  bool cut = false;
  for (int i = -kFootColumns; i <= kFootColumns; ++i) {
    const double aside = reach * i / kFootColumns;
    const PixelPoint from{patch.centre.x - aside * up.dy, patch.centre.y + aside * up.dx};
    if (!Sampler::usable(from)) continue;
    const Foot foot = footBelow(scene, from, up);
    if (foot.end == FootEnd::carpet && foot.distance < best.distance) best = foot;
    cut = cut || foot.end == FootEnd::imageBorder;
  }
  if (cut) best.end = FootEnd::imageBorder;
  return best;
}

// Share of white and grey on a ring 2 px outside the patch's box.
double shellRound(const Scene& scene, const PixelBox& box) {
  const double x = 0.5 * (box.left + box.right);
  const double y = 0.5 * (box.top + box.bottom);
  int shell = 0;
  int seen = 0;
  for (int i = 0; i < kShellPoints; ++i) {
    const auto direction = maths::sinCos(2.0 * maths::kPi * i / kShellPoints);
    const PixelPoint at{x + direction.cos * (0.6 * widthOf(box) + 2.0),
                        y + direction.sin * (0.6 * heightOf(box) + 2.0)};
    if (!Sampler::usable(at)) continue;
    const ColourClass c = scene.sampler.classAt(at);
    shell += c == ColourClass::white || c == ColourClass::grey ? 1 : 0;
    ++seen;
  }
  return seen > 0 ? static_cast<double>(shell) / seen : 0.0;
}

// Distance by the height that patches have, for a robot whose feet the image border cuts.
double distanceByHeight(const Scene& scene, const RobotPatch& patch, const RobotParams& p) {
  const double slope = sightOf(scene.body.camera, patch.centre).slope;
  const double below = scene.body.camera.position.z - p.patchHeight;
  if (slope > -0.02 || below < 1.0) return p.maxCutDistance;
  return std::min(-below / slope, p.maxCutDistance);
}

void locate(const Scene& scene, RobotPatch& patch, const RobotParams& p) {
  patch.foot = nearestFoot(scene, patch, 0.5 * widthOf(patch.box));
  for (int round = 0; round < 2; ++round) {
    const bool cut = patch.foot.end != FootEnd::carpet;
    patch.distance = cut ? distanceByHeight(scene, patch, p) : patch.foot.distance;
    patch.scale = scaleAt(scene, patch.distance, p.patchHeight);
    if (round == 0) {
      patch.foot = nearestFoot(scene, patch, 0.5 * widthOf(patch.box) + p.reach * patch.scale);
    }
  }
  patch.height = heightAt(scene.body.camera, patch.centre, patch.distance);
  patch.shell = shellRound(scene, patch.box);
}

bool check(bool keep, Refusal reason, VisionCounts& counts) {
  if (!keep) refuse(counts, reason);
  return keep;
}

// What can be told before the foot is looked for.
bool mayBePatch(const Scene& scene, const RobotPatch& patch, const RobotParams& p,
                VisionCounts& counts) {
  return check(robotPatchIsLarge(patch, p), Refusal::robotTooSmall, counts) &&
         check(robotPatchIsLow(scene, patch, p), Refusal::robotAboveHorizon, counts);
}

bool accepted(const Scene& scene, const RobotPatch& patch, const RobotParams& p,
              VisionCounts& counts) {
  return check(robotIsInsideFieldEdge(scene, patch, p), Refusal::robotAboveFieldEdge, counts) &&
         check(robotIsNear(patch, p), Refusal::robotTooFar, counts) &&
         check(robotStandsOnGround(patch, p), Refusal::robotOffGround, counts) &&
         check(robotPatchHasSize(patch, p), Refusal::robotSize, counts) &&
         check(robotHasShell(patch, p), Refusal::robotNoShell, counts);
}

// The largest candidates, largest first.
Patches largestPatches(const Scene& scene, const RobotParams& p, VisionCounts& counts) {
  Patches found;
  for (const Blob& blob : scene.blobs) {
    const bool red = blob.colour == ColourClass::robotRed;
    if (!red && blob.colour != ColourClass::robotBlue) continue;
    RobotPatch item;
    item.team = red ? TeamColour::red : TeamColour::blue;
    item.samples = blob.samples;
    item.box = blob.box;
    item.centre = blob.centre;
    if (!mayBePatch(scene, item, p, counts)) continue;
    for (RobotPatch& kept : found) {
      if (item.samples > kept.samples) std::swap(item, kept);
    }
    found.push_back(item);
  }
  return found;
}

PixelBox joined(const PixelBox& a, const PixelBox& b) {
  return {std::min(a.left, b.left), std::min(a.top, b.top), std::max(a.right, b.right),
          std::max(a.bottom, b.bottom)};
}

// Puts a patch to the robot it belongs to; the nearest leg of all decides the distance.
void addToGroups(const RobotPatch& patch, const RobotParams& p, Patches& groups) {
  for (RobotPatch& group : groups) {
    if (!areOfOneRobot(group, patch, p)) continue;
    group.box = joined(group.box, patch.box);
    if (patch.foot.end == FootEnd::carpet &&
        (group.foot.end != FootEnd::carpet || patch.distance < group.distance)) {
      group.foot = patch.foot;
      group.distance = patch.distance;
      group.scale = patch.scale;
    }
    group.samples += patch.samples;
    return;
  }
  groups.push_back(patch);
}

double distanceSd(const Scene& scene, const RobotPatch& group, const RobotParams& p) {
  const double above = scene.body.camera.position.z;
  const double d = group.distance;
  if (group.foot.end != FootEnd::carpet) {
    return std::min(d * p.heightSd / std::max(above - p.patchHeight, 1.0), p.maxCutDistance);
  }
  const double pixel = p.edgeSd / body::kFocalLength;
  const double direction = maths::hypot(p.directionSd.rad(), pixel);
  return maths::hypot((d * d + above * above) / above * direction, 0.5 * p.depth);
}

RobotPercept perceptOf(const Scene& scene, const RobotPatch& group, const RobotParams& p) {
  const PixelPoint middle{0.5 * (group.box.left + group.box.right),
                          0.5 * (group.box.top + group.box.bottom)};
  const Sight sight = sightOf(scene.body.camera, middle);
  const Point2<Robot> place = placeAt(scene.body.camera, sight, group.distance + p.depth);
  RobotPercept robot;
  robot.team = group.team;
  robot.distance = place.norm();
  robot.heading = bearing(place);
  robot.elevation = Angle::rad(maths::atan(sight.slope));
  robot.distanceVariance = maths::square(distanceSd(scene, group, p));
  robot.headingVariance = maths::square(p.headingSd / std::max(robot.distance, 10.0));
  robot.box = group.box;
  return robot;
}

}  // namespace

bool robotPatchIsLarge(const RobotPatch& patch, const RobotParams& p) {
  return patch.samples >= p.minSamples;
}

bool robotPatchIsLow(const Scene& scene, const RobotPatch& patch, const RobotParams& p) {
  return patch.box.bottom >= horizonRow(scene, patch.centre.x) - p.maxAboveHorizon;
}

bool robotPatchHasSize(const RobotPatch& patch, const RobotParams& p) {
  return widthOf(patch.box) <= p.maxPatchWidth * patch.scale + 2.0 &&
         heightOf(patch.box) <= p.maxPatchHeight * patch.scale + 2.0;
}

bool robotHasShell(const RobotPatch& patch, const RobotParams& p) {
  return patch.shell >= p.minShell;
}

bool robotIsInsideFieldEdge(const Scene& scene, const RobotPatch& patch, const RobotParams& p) {
  if (patch.foot.end != FootEnd::carpet) return true;
  const double edge = fieldEdgeRow(scene, patch.foot.pixel.x);
  return patch.foot.pixel.y >= edge + p.minInsideFieldEdge;
}

bool robotStandsOnGround(const RobotPatch& patch, const RobotParams& p) {
  if (patch.foot.end == FootEnd::hidden) return false;
  return patch.height >= p.minHeight && patch.height <= p.maxHeight;
}

bool robotIsNear(const RobotPatch& patch, const RobotParams& p) {
  const bool cut = patch.foot.end != FootEnd::carpet;
  return patch.distance <= (cut ? p.maxCutDistance : p.maxDistance);
}

bool areOfOneRobot(const RobotPatch& a, const RobotPatch& b, const RobotParams& p) {
  if (a.team != b.team) return false;
  const double scale = std::max(a.scale, b.scale);
  const double gap = std::max(a.box.left, b.box.left) - std::min(a.box.right, b.box.right);
  const PixelBox both = joined(a.box, b.box);
  const double near = std::min(a.distance, b.distance);
  const double far = std::max(a.distance, b.distance);
  return gap <= p.maxGap * scale && widthOf(both) <= p.maxLength * scale + 2.0 &&
         far <= p.maxDepthRatio * near + 5.0;
}

void findRobots(const Scene& scene, const RobotParams& params, VisionCounts& counts,
                Robots& robots) {
  Patches groups;
  for (RobotPatch& patch : largestPatches(scene, params, counts)) {
    locate(scene, patch, params);
    if (accepted(scene, patch, params, counts)) addToGroups(patch, params, groups);
  }
  for (const RobotPatch& group : groups) robots.push_back(perceptOf(scene, group, params));
}

}  // namespace kelpie::vision
