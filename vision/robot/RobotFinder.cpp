// SPDX-License-Identifier: Apache-2.0
#include "vision/robot/RobotFinder.h"

#include <algorithm>
#include <cmath>

#include "robot/core/Maths.h"
#include "robot/core/ScratchVector.h"
#include "vision/ElevationDoubt.h"
#include "vision/Refusal.h"
#include "vision/pixels/GroundRay.h"

namespace kelpie::vision {
namespace {

constexpr std::size_t kMaxPatches = 16;
constexpr double kSameDepth = 0.2;  // share of its distance by which a leg may seem off
using Patches = ScratchVector<RobotPatch, kMaxPatches>;
using Groups = ScratchVector<PatchGroup, kMaxPatches>;

bool check(bool keep, Refusal reason, VisionCounts& counts) {
  if (!keep) refuse(counts, reason);
  return keep;
}

// What can be checked before the foot is looked for.
bool mayBePatch(const Scene& scene, const RobotPatch& patch, const RobotFinderParams& p,
                VisionCounts& counts) {
  return check(robotPatchHasColour(patch, p), Refusal::robotOtherColour, counts) &&
         check(robotPatchIsLow(scene, patch, p), Refusal::robotAboveHorizon, counts);
}

bool standsOnField(const RobotPatch& patch, const RobotFinderParams& p, VisionCounts& counts) {
  return check(robotStandsOnGround(patch, p), Refusal::robotOffGround, counts) &&
         check(robotFeetMayBeCut(patch, p), Refusal::robotFeetNear, counts) &&
         check(robotPatchHasSize(patch, p), Refusal::robotSize, counts) &&
         check(patch.foot.distance <= p.maxDistance + patch.distanceSd, Refusal::robotTooFar,
               counts);
}

bool looksLikeRobot(const Scene& scene, const RobotFinderParams& p, RobotPatch& patch,
                    VisionCounts& counts) {
  measureSurroundings(scene, patch);
  return check(robotPatchIsPure(patch, p), Refusal::robotOtherColour, counts) &&
         check(robotIsNoSpeck(patch, p), Refusal::robotSpeck, counts) &&
         check(robotIsInsideFieldEdge(scene, patch, p), Refusal::robotAboveFieldEdge, counts) &&
         check(robotIsNear(patch, p), Refusal::robotTooFar, counts) &&
         check(robotHasShell(patch, p), Refusal::robotNoShell, counts);
}

// The largest candidates, largest first.
Patches largestPatches(const Scene& scene, const RobotFinderParams& p, VisionCounts& counts) {
  Patches found;
  for (const Blob& blob : scene.blobs) {
    if (blob.colour != ColourClass::robotRed && blob.colour != ColourClass::robotBlue) continue;
    if (blob.samples < p.minSamples) {
      refuse(counts, Refusal::robotTooSmall);
      continue;
    }
    RobotPatch item = patchOf(scene, blob);
    if (!mayBePatch(scene, item, p, counts)) continue;
    for (RobotPatch& kept : found) {
      if (item.samples > kept.samples) std::swap(item, kept);
    }
    found.push_back(item);
  }
  return found;
}

// Whether a group is specks of the other team's colour on a robot that has much more of its own:
// clothes that show beside its head.
bool isOnAnother(const PatchGroup& group, const Groups& groups, const RobotFinderParams& p) {
  for (PatchGroup other : groups) {
    if (other.team == group.team || other.samples < p.minTeamRatio * group.samples) continue;
    const double depth = other.distance - group.distance;
    if (std::fabs(depth) > kSameDepth * other.distance) continue;
    other.team = group.team;
    if (areOfOneRobot(other, group, p)) return true;
  }
  return false;
}

void addToGroups(const PatchGroup& patch, const RobotFinderParams& p, Groups& groups) {
  for (PatchGroup& group : groups) {
    if (!areOfOneRobot(group, patch, p)) continue;
    group = joined(group, patch);
    return;
  }
  groups.push_back(patch);
}

void bringNearer(const PatchGroup& part, const RobotFinderParams& p, Groups& groups) {
  for (PatchGroup& group : groups) {
    if (areOfOneRobot(group, part, p)) group = nearer(group, part);
  }
}

RobotFacts factsOf(const PatchGroup& group) {
  RobotFacts facts = group.facts;
  facts.samples = group.samples;
  return facts;
}

double distanceSd(const Scene& scene, const PatchGroup& group, const RobotFinderParams& p) {
  constexpr double kCutSd = 0.4;  // of the distance, of a robot whose feet the image cuts
  const CameraPose& camera = scene.body.camera;
  const double above = camera.position.z;
  const double d = group.distance;
  if (group.cut) return kCutSd * d;
  const double direction =
      maths::hypot(maths::hypot(p.directionSd.rad(), p.edgeSd / focalLength(scene)),
                   elevationDoubt(camera, groundRayThrough(camera, group.centre)).sd);
  return maths::hypot((d * d + above * above) / above * direction, 0.5 * p.depth);
}

RobotPercept perceptOf(const Scene& scene, const PatchGroup& group, const RobotFinderParams& p) {
  constexpr double kMinDistance = 10.0;  // cm
  const double lateral = 0.5 * (group.left + group.right) - scene.frame.along(group.centre);
  const PixelPoint middle = moved(group.centre, scene.frame.right(), lateral);
  const GroundRay ray = groundRayThrough(scene.body.camera, middle);
  const Point2<Robot> place = placeAt(scene.body.camera, ray, group.distance + p.depth);
  RobotPercept robot;
  robot.team = group.team;
  robot.distance = place.norm();
  robot.heading = bearing(place);
  robot.elevation = Angle::rad(maths::atan(ray.slope));
  robot.distanceVariance = maths::square(distanceSd(scene, group, p));
  robot.headingVariance = maths::square(p.headingSd / std::max(robot.distance, kMinDistance));
  robot.box = group.box;
  return robot;
}

}  // namespace

PatchGroup groupOf(const RobotPatch& patch, const HorizonFrame& frame) {
  const double at = frame.along(patch.centre);
  return {patch.team,
          patch.samples,
          at - patch.extent.left,
          at + patch.extent.right,
          patch.centre,
          patch.box,
          patch.foot.end != FootEnd::carpet,
          patch.distance,
          patch.scale,
          {}};
}

bool areOfOneRobot(const PatchGroup& a, const PatchGroup& b, const RobotFinderParams& p) {
  constexpr double kLengthSlack = 2.0;  // px
  constexpr double kDepthSlack = 5.0;   // cm
  if (a.team != b.team) return false;
  const double scale = std::max(a.scale, b.scale);
  const double gap = std::max(a.left, b.left) - std::min(a.right, b.right);
  const double length = std::max(a.right, b.right) - std::min(a.left, b.left);
  const double near = std::min(a.distance, b.distance);
  const double far = std::max(a.distance, b.distance);
  return gap <= p.maxGap * scale && length <= p.maxLength * scale + kLengthSlack &&
         far <= p.maxDepthRatio * near + kDepthSlack;
}

// The nearest leg of all decides the distance, but feet in the image count more than feet cut off.
PatchGroup joined(const PatchGroup& larger, const PatchGroup& other) {
  PatchGroup both = larger;
  both.samples += other.samples;
  both.facts.patches += other.facts.patches;
  both.left = std::min(larger.left, other.left);
  both.right = std::max(larger.right, other.right);
  both.box = {std::min(larger.box.left, other.box.left), std::min(larger.box.top, other.box.top),
              std::max(larger.box.right, other.box.right),
              std::max(larger.box.bottom, other.box.bottom)};
  if (other.cut < larger.cut || (other.cut == larger.cut && other.distance < larger.distance)) {
    both.cut = other.cut;
    both.distance = other.distance;
    both.scale = other.scale;
  }
  return both;
}

PatchGroup nearer(const PatchGroup& group, const PatchGroup& part) {
  if (part.distance >= group.distance) return group;
  PatchGroup both = group;
  both.distance = part.distance;
  both.scale = part.scale;
  both.cut = part.cut;
  return both;
}

void findRobots(const Scene& scene, const RobotFinderParams& params, VisionCounts& counts,
                Robots& robots, JudgedRobots& judged) {
  Groups groups;
  Groups parts;
  for (RobotPatch& patch : largestPatches(scene, params, counts)) {
    measurePatch(scene, params, patch);
    const bool sure =
        standsOnField(patch, params, counts) && looksLikeRobot(scene, params, patch, counts);
    if (sure) {
      PatchGroup group = groupOf(patch, scene.frame);
      group.facts = robotFacts(scene, patch);
      addToGroups(group, params, groups);
    } else if (robotPatchTellsDistance(patch, params)) {
      parts.push_back(groupOf(patch, scene.frame));
    }
  }
  for (const PatchGroup& part : parts) bringNearer(part, params, groups);
  for (const PatchGroup& group : groups) {
    if (!check(!isOnAnother(group, groups, params), Refusal::robotOnAnother, counts)) continue;
    const RobotFacts facts = factsOf(group);
    const JudgedRobot robot{perceptOf(scene, group, params), facts, logOddsAgainst(facts)};
    judged.push_back(robot);
    if (check(robot.logOddsAgainst <= params.maxLogOddsAgainst, Refusal::robotUnlikely, counts))
      robots.push_back(robot.percept);
  }
}

}  // namespace kelpie::vision
