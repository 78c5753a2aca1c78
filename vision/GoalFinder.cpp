// SPDX-License-Identifier: Apache-2.0
#include "vision/GoalFinder.h"

#include <algorithm>
#include <cmath>

#include "vision/GoalColumns.h"
#include "vision/Refusal.h"
#include "vision/Sight.h"
#include "vision/SpanWalk.h"

namespace kelpie::vision {
namespace {

constexpr double kHalfMouth = 40.0;      // cm
constexpr std::uint32_t kLeastPart = 6;  // samples of a blob worth joining

bool contains(const PixelBox& box, PixelPoint p, double margin) {
  return p.x >= box.left - margin && p.x <= box.right + margin && p.y >= box.top - margin &&
         p.y <= box.bottom + margin;
}

bool isBandOf(const LandmarkPercept& beacon, ColourClass colour) {
  switch (beacon.kind) {
    case LandmarkKind::beaconBlueOnPink:
    case LandmarkKind::beaconPinkOnBlue: return colour == ColourClass::blue;
    case LandmarkKind::beaconYellowOnPink:
    case LandmarkKind::beaconPinkOnYellow: return colour == ColourClass::yellow;
    default: return false;
  }
}

bool isBeaconBand(const Blob& blob, const Landmarks& landmarks) {
  return std::any_of(landmarks.begin(), landmarks.end(), [&blob](const LandmarkPercept& l) {
    return isBandOf(l, blob.colour) && contains(l.box, blob.centre, 2.0);
  });
}

double overlap(double a0, double a1, double b0, double b1) {
  return std::min(a1, b1) - std::max(a0, b0);
}

// Parts of one goal stand side by side (a goalie between) or touch.
bool belongs(const PixelBox& goal, const PixelBox& part) {
  const double height = std::min(goal.bottom - goal.top, part.bottom - part.top);
  const double gap = -overlap(goal.left, goal.right, part.left, part.right);
  const double rows = overlap(goal.top, goal.bottom, part.top, part.bottom);
  return rows >= 0.5 * height && gap <= 0.8 * (goal.right - goal.left);
}

PixelBox hull(const PixelBox& a, const PixelBox& b) {
  return {std::min(a.left, b.left), std::min(a.top, b.top), std::max(a.right, b.right),
          std::max(a.bottom, b.bottom)};
}

constexpr std::size_t kMaxSeeds = 4;
using Seeds = FixedVector<const Blob*, kMaxSeeds>;

// The largest blobs of a colour, largest first.
Seeds seedsOf(const Scene& scene, ColourClass colour, const Landmarks& beacons) {
  Seeds found;
  for (const Blob& blob : scene.blobs) {
    if (blob.colour != colour || isBeaconBand(blob, beacons)) continue;
    const Blob* item = &blob;
    for (const Blob*& kept : found) {
      if (item->samples > kept->samples) std::swap(item, kept);
    }
    found.push_back(item);
  }
  return found;
}

GoalCandidate alone(const Blob& seed) {
  GoalCandidate c;
  c.colour = seed.colour;
  c.box = seed.box;
  c.samples = seed.samples;
  return c;
}

// The seed with what stands beside it, a goalie between; the same as alone when nothing does.
GoalCandidate grouped(const Scene& scene, const Blob& seed, const Landmarks& beacons) {
  GoalCandidate c = alone(seed);
  for (const Blob& blob : scene.blobs) {
    if (&blob == &seed || blob.colour != c.colour || blob.samples < kLeastPart) continue;
    if (isBeaconBand(blob, beacons) || !belongs(c.box, blob.box)) continue;
    c.box = hull(c.box, blob.box);
    c.samples += blob.samples;
  }
  return c;
}

// Places on the ground, relative to the robot: the two ends seen and the middle of the mouth.
struct GoalPlaces {
  Point2<Robot> left;
  Point2<Robot> right;
  Point2<Robot> middle;
  double hidden = 0.0;  // cm, how much of the mouth is outside the image
};

Point2<Robot> sideways(Point2<Robot> from, const Sight& sight, double toRight) {
  return {from.x + toRight * sight.forward, from.y - toRight * sight.right};
}

GoalPlaces placesOf(const Scene& scene, const GoalCandidate& c) {
  const CameraPose& camera = scene.body.camera;
  const Sight l = sightOf(camera, c.leftEdge);
  const Sight r = sightOf(camera, c.rightEdge);
  GoalPlaces places;
  places.left = placeAt(camera, l, c.distance);
  places.right = placeAt(camera, r, c.distance);
  places.middle = (places.left + places.right) * 0.5;
  const double seen = distance(places.left, places.right);
  if (!c.leftCut && !c.rightCut) return places;
  places.hidden = std::max(0.0, 2.0 * kHalfMouth - seen);
  if (seen >= 2.0 * kHalfMouth || c.leftCut == c.rightCut) return places;
  places.middle =
      c.leftCut ? sideways(places.right, r, -kHalfMouth) : sideways(places.left, l, kHalfMouth);
  return places;
}

LandmarkPercept perceptOf(const Scene& scene, const GoalCandidate& c, const GoalParams& p) {
  const GoalPlaces places = placesOf(scene, c);
  LandmarkPercept percept;
  percept.kind = c.colour == ColourClass::blue ? LandmarkKind::goalBlue : LandmarkKind::goalYellow;
  percept.distance = places.middle.norm();
  percept.heading = bearing(places.middle);
  const PixelPoint middle{0.5 * (c.box.left + c.box.right), 0.5 * (c.box.top + c.box.bottom)};
  percept.elevation = Angle::rad(maths::atan(sightOf(scene.body.camera, middle).slope));
  percept.distanceVariance = maths::square(c.distanceSd) + maths::square(0.05 * percept.distance) +
                             maths::square(0.25 * places.hidden);
  percept.headingVariance = maths::square(p.headingSd.rad()) +
                            maths::square(0.25 * places.hidden / std::max(percept.distance, 20.0));
  percept.leftEdge = bearing(places.left);
  percept.rightEdge = bearing(places.right);
  percept.leftEdgeCut = c.leftCut;
  percept.rightEdgeCut = c.rightCut;
  percept.box = c.box;
  return percept;
}

bool accepted(const Scene& scene, const GoalCandidate& c, const GoalParams& p,
              VisionCounts& counts) {
  const auto check = [&counts](bool keep, Refusal reason) {
    if (!keep) refuse(counts, reason);
    return keep;
  };
  return check(goalHasShape(c, p), Refusal::goalAspect) &&
         check(goalStandsBelowHorizon(scene, c, p), Refusal::goalAboveHorizon) &&
         check(goalStandsInsideFieldEdge(scene, c, p), Refusal::goalAboveFieldEdge) &&
         check(goalHasNoPinkBeside(scene, c), Refusal::goalIsBeacon) &&
         check(goalHasFieldBelow(c, p), Refusal::goalNoField) &&
         check(goalIsMeasured(c), Refusal::goalNoHeight) &&
         check(goalHasWidth(scene, c, p), Refusal::goalWidth) &&
         check(goalStandsOnGround(c, p), Refusal::goalOffGround) &&
         check(goalIsNear(c, p), Refusal::goalTooFar);
}

bool tried(const Scene& scene, GoalCandidate& c, const GoalParams& p, VisionCounts& counts) {
  if (!goalIsLarge(c, p)) {
    refuse(counts, Refusal::goalTooSmall);
    return false;
  }
  measureGoal(scene, p, c);
  return accepted(scene, c, p, counts);
}

// The one whose width is nearer to a goal's; a part of one that an image border cuts counts as far.
void keepBetter(const Scene& scene, const GoalCandidate& c, GoalCandidate& best) {
  const auto misfit = [&scene](const GoalCandidate& g) {
    const GoalPlaces places = placesOf(scene, g);
    return std::fabs(distance(places.left, places.right) - 2.0 * kHalfMouth);
  };
  if (!goalIsMeasured(best) || misfit(c) < misfit(best)) best = c;
}

double middleX(const GoalCandidate& c) { return 0.5 * (c.box.left + c.box.right); }

}  // namespace

bool goalIsLarge(const GoalCandidate& c, const GoalParams& p) {
  return c.samples >= p.minSamples && c.box.right - c.box.left >= p.minWidth &&
         c.box.bottom - c.box.top >= p.minHeight;
}

bool goalHasShape(const GoalCandidate& c, const GoalParams& p) {
  const double width = c.box.right - c.box.left;
  const double height = c.box.bottom - c.box.top;
  const bool sideCut = c.leftCut || c.rightCut;
  const bool tall = !sideCut && height > p.maxTall * width;
  const bool flat = !c.topCut && !c.bottomCut && width > p.maxFlat * height;
  const bool beyondTop = 3 * c.tallColumns > c.columns;
  return !tall && !flat && !beyondTop;
}

bool goalStandsBelowHorizon(const Scene& scene, const GoalCandidate& c, const GoalParams& p) {
  return c.box.bottom >= horizonRow(scene, middleX(c)) - p.maxAboveHorizon;
}

bool goalStandsInsideFieldEdge(const Scene& scene, const GoalCandidate& c, const GoalParams& p) {
  return c.box.bottom >= fieldEdgeRow(scene, middleX(c)) - p.maxAboveFieldEdge;
}

bool goalHasFieldBelow(const GoalCandidate& c, const GoalParams& p) {
  return c.fieldColumns >= p.minFieldColumns * c.columns;
}

// A beacon that was not recognised has its pink right above or below.
bool goalHasNoPinkBeside(const Scene& scene, const GoalCandidate& c) {
  const double height = c.box.bottom - c.box.top;
  for (const double share : {0.15, 0.35, 0.55}) {
    const double away = 1.0 + share * height;
    for (const double y : {c.box.top - away, c.box.bottom + away}) {
      const PixelPoint at{middleX(c), y};
      if (Sampler::usable(at) && scene.sampler.classAt(at) == ColourClass::pink) return false;
    }
  }
  return true;
}

bool goalIsMeasured(const GoalCandidate& c) { return c.distance > 0.0; }

bool goalHasWidth(const Scene& scene, const GoalCandidate& c, const GoalParams& p) {
  const GoalPlaces places = placesOf(scene, c);
  const double seen = distance(places.left, places.right);
  const double least = c.leftCut || c.rightCut ? p.minCutWidth : p.minSeenWidth;
  const bool narrow = seen < least;
  return !narrow && seen <= p.maxSeenWidth;
}

bool goalStandsOnGround(const GoalCandidate& c, const GoalParams& p) {
  return std::fabs(c.footError) <= p.directionError.rad();
}

bool goalIsNear(const GoalCandidate& c, const GoalParams& p) { return c.distance <= p.maxDistance; }

void findGoals(const Scene& scene, const GoalParams& params, VisionCounts& counts,
               Landmarks& landmarks) {
  const Landmarks beacons = landmarks;
  for (const ColourClass colour : {ColourClass::blue, ColourClass::yellow}) {
    GoalCandidate best;
    for (const Blob* seed : seedsOf(scene, colour, beacons)) {
      GoalCandidate group = grouped(scene, *seed, beacons);
      const bool same = group.samples == seed->samples;
      GoalCandidate single = alone(*seed);
      if (tried(scene, group, params, counts)) keepBetter(scene, group, best);
      if (!same && tried(scene, single, params, counts)) keepBetter(scene, single, best);
    }
    if (goalIsMeasured(best)) landmarks.push_back(perceptOf(scene, best, params));
  }
}

}  // namespace kelpie::vision
