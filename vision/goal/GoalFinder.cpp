// SPDX-License-Identifier: Apache-2.0
#include "vision/goal/GoalFinder.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "robot/core/ScratchVector.h"
#include "vision/Refusal.h"
#include "vision/goal/GoalColumns.h"
#include "vision/goal/GoalCurves.h"
#include "vision/goal/GoalFacts.h"
#include "vision/goal/GoalPlace.h"
#include "vision/goal/GoalShape.h"
#include "vision/pixels/GroundRay.h"
#include "vision/pixels/SpanWalk.h"

namespace kelpie::vision {
namespace {

constexpr double kBeaconAspect = 1.3;  // a beacon's band is no wider for its height
constexpr std::uint32_t kMinPart = 6;  // samples of a blob that is joined

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
  constexpr double kMargin = 2.0;  // px
  for (const LandmarkPercept& l : landmarks)
    if (isBandOf(l, blob.colour) && contains(l.box, blob.centre, kMargin)) return true;
  return false;
}

double overlap(double a0, double a1, double b0, double b1) {
  return std::min(a1, b1) - std::max(a0, b0);
}

// Parts of one goal stand side by side (a goalie between) or touch.
bool belongs(const LevelBox& goal, const LevelBox& part) {
  constexpr double kMinCommonRows = 0.5;  // of the lower one's height
  constexpr double kMaxGap = 0.8;         // of the goal's width, which a goalie hides
  const double height = std::min(goal.bottom - goal.top, part.bottom - part.top);
  const double gap = -overlap(goal.left, goal.right, part.left, part.right);
  const double rows = overlap(goal.top, goal.bottom, part.top, part.bottom);
  return rows >= kMinCommonRows * height && gap <= kMaxGap * (goal.right - goal.left);
}

LevelBox hull(const LevelBox& a, const LevelBox& b) {
  return {std::min(a.left, b.left), std::min(a.top, b.top), std::max(a.right, b.right),
          std::max(a.bottom, b.bottom)};
}

constexpr std::size_t kMaxSeeds = 4;
using Seeds = ScratchVector<const Blob*, kMaxSeeds>;

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
    if (&blob == &seed || blob.colour != c.colour || blob.samples < kMinPart) continue;
    if (isBeaconBand(blob, beacons) || !belongs(c.box, blob.box)) continue;
    c.box = hull(c.box, blob.box);
    c.samples += blob.samples;
  }
  return c;
}

// What tells one group from another.
struct Region {
  std::uint32_t samples = 0;
  LevelBox box;
};

bool areSame(const Region& a, const Region& b) {
  return a.samples == b.samples && a.box.left == b.box.left && a.box.right == b.box.right &&
         a.box.top == b.box.top && a.box.bottom == b.box.bottom;
}

// Of the median of the columns whose feet and tops are seen.
ElevationError elevationErrorOf(const Scene& scene, const GoalCandidate& c,
                                const GoalFinderParams& p) {
  ScratchVector<double, kGoalColumns> errors;
  for (const GoalColumn& column : c.columns)
    if (column.chosen && !column.topCut && column.distance > 0.0)
      errors.push_back(column.footError);
  if (errors.size() < 2) return {};
  std::sort(errors.begin(), errors.end());
  const double pixel = p.edgeSd / focalLength(scene);
  const double share = kRootTwo * scene.body.camera.position.z / scene.field.goalHeight;
  return {Angle::rad(errors[errors.size() / 2]), pixel * pixel * (1.0 + share * share)};
}

// cm by which the middle of the mouth is uncertain because of what is cut or hidden. One end that
// is seen ties the rest to the mouth's width; without any the squared errors were 2.6 times those
// of a quarter of what is not seen (`kelpie evaluate cut-goals`).
double hiddenSd(const Scene& scene, const GoalCandidate& c) {
  constexpr double kOneEnd = 0.25;
  constexpr double kNoEnd = 0.4;
  if (!c.left.open() && !c.right.open()) return 0.0;
  const double hidden = std::max(0.0, scene.field.goalWidth - visibleWidth(scene, c));
  return (c.left.open() && c.right.open() ? kNoEnd : kOneEnd) * hidden;
}

// cm of the same by the goal's own turn, which the heights of its columns tell: in randomised
// worlds headings of whole goals were off by 2 deg at 3.5 m, with squared errors three to five
// times what one degree allows (`kelpie evaluate cut-goals --randomise 21`).
constexpr double kAlongByTurnSd = 4.0;

LandmarkPercept perceptOf(const Scene& scene, const GoalCandidate& c, const GoalShape& shape,
                          const GoalFinderParams& p) {
  constexpr double kDistanceShare = 0.05;  // sd of the distance, over it
  constexpr double kMinDistance = 20.0;    // cm
  const Point3<Robot>& eye = scene.body.camera.position;
  const Point2<Robot> camera{eye.x, eye.y};
  const Point2<Robot> middle = camera + shape.middle;
  const double across = hiddenSd(scene, c);
  LandmarkPercept percept;
  percept.kind = goalKind(c.colour);
  percept.distance = middle.norm();
  percept.heading = bearing(middle);
  const PixelPoint centre = scene.frame.toImage({c.box.middle(), 0.5 * (c.box.top + c.box.bottom)});
  percept.elevation = Angle::rad(maths::atan(groundRayThrough(scene.body.camera, centre).slope));
  percept.distanceVariance = maths::square(c.distanceSd) +
                             maths::square(kDistanceShare * percept.distance) +
                             maths::square(across);
  percept.headingVariance =
      maths::square(p.headingSd.rad()) +
      maths::square(std::max(across, kAlongByTurnSd) / std::max(percept.distance, kMinDistance));
  percept.elevationError = elevationErrorOf(scene, c, p);
  percept.leftEdge = bearing(camera + shape.leftPost(scene.field));
  percept.rightEdge = bearing(camera + shape.rightPost(scene.field));
  percept.leftEdgeCut = c.left.open();
  percept.rightEdgeCut = c.right.open();
  percept.box = imageBox(scene.frame, c.box);
  return percept;
}

bool accepted(const Scene& scene, const GoalCandidate& c, const GoalFinderParams& p,
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
         check(goalIsNear(c, p), Refusal::goalTooFar);
}

bool tried(const Scene& scene, const CarpetColour& carpet, GoalCandidate& c,
           const GoalFinderParams& p, VisionCounts& counts) {
  if (!goalIsLarge(c, p)) {
    refuse(counts, Refusal::goalTooSmall);
    return false;
  }
  measureGoal(scene, p, carpet, c);
  return accepted(scene, c, p, counts);
}

// A narrow part of a goal seems turned away when its ends are taken for posts: then what hides the
// rest was not recognised.
GoalShape shapeOf(const Scene& scene, GoalCandidate& c, const GoalFinderParams& p) {
  const GoalShape shape = fitGoal(scene, c);
  if (goalFacesField(shape, p) || !goalIsPart(scene, c, p)) return shape;
  c.left.hidden = true;
  c.right.hidden = true;
  return fitGoal(scene, c);
}

// The lowest point of the middle.
PixelPoint footOf(const Scene& scene, const GoalCandidate& c) {
  return scene.frame.toImage({c.box.middle(), c.box.bottom});
}

// A box behind the carpet stands a little above the field edge, or its feet do not fit the ground.
bool hasFirmFeet(const Scene& scene, const GoalCandidate& c, const GoalFinderParams& p) {
  if (std::fabs(c.settledFootError()) > p.partDirection.rad()) return false;
  const GoalFeet feet = feetOf(scene, c);
  return feet.count == 0 || (feet.lowest >= p.minPartBelowFieldEdge &&
                             feet.sum >= -p.maxPartMeanAboveFieldEdge * feet.count);
}

struct Likeliest {
  bool found = false;
  GoalCandidate candidate;
  GoalShape shape;
  LandmarkPercept percept;
  double logOddsAgainst = 0.0;
};

struct Finder {
  const Scene& scene;
  const GoalFinderParams& params;
  const Landmarks& beacons;
  VisionCounts& counts;
  JudgedGoals& judged;
  CarpetColour carpet;  // for blue ones

  // The candidate with the least log odds against it is the goal: the two goals are at opposite
  // ends, so that one image shows one of them (facts-2005 4.5 check 10).
  void consider(GoalCandidate c, Likeliest& best) const {
    if (!tried(scene, carpet, c, params, counts)) return;
    const GoalShape shape = shapeOf(scene, c, params);
    if (!goalFacesField(shape, params)) return refuse(counts, Refusal::goalOblique);
    GoalFacts facts = goalFacts(scene, c, shape);
    addPlace(scene, c, shape, beacons, facts);
    const double against = logOddsAgainst(facts);
    const LandmarkPercept percept = perceptOf(scene, c, shape, params);
    judged.push_back({percept, facts, against});
    if (against > params.maxLogOddsAgainst) return refuse(counts, Refusal::goalUnlikely);
    if (best.found && best.candidate.colour != c.colour) refuse(counts, Refusal::goalOpposite);
    if (!best.found || against < best.logOddsAgainst) best = {true, c, shape, percept, against};
  }
};

}  // namespace

bool goalIsLarge(const GoalCandidate& c, const GoalFinderParams& p) {
  return c.samples >= p.minSamples && c.box.width() >= p.minWidth && c.box.height() >= p.minHeight;
}

bool goalHasShape(const GoalCandidate& c, const GoalFinderParams& p) {
  const bool sideCut = c.left.cut || c.right.cut;
  const bool tall = !sideCut && c.box.height() > p.maxTall * c.box.width();
  const bool flat = !c.topCut && !c.bottomCut && c.box.width() > p.maxFlat * c.box.height();
  int tallColumns = 0;
  for (const GoalColumn& column : c.columns) tallColumns += column.tall ? 1 : 0;
  return !tall && !flat && 2 * tallColumns <= 3 * countColumns(c).chosen;
}

bool goalStandsBelowHorizon(const Scene& scene, const GoalCandidate& c, const GoalFinderParams& p) {
  return belowHorizon(scene, footOf(scene, c)) >= -p.maxAboveHorizon - rowSlack(scene);
}

// A goal stands on the carpet, clothes on the floor behind it: some column's foot meets the edge.
bool goalStandsInsideFieldEdge(const Scene& scene, const GoalCandidate& c,
                               const GoalFinderParams& p) {
  const GoalFeet feet = feetOf(scene, c);
  return feet.count == 0 ||
         (feet.lowest >= -p.maxAboveFieldEdge && feet.sum >= -p.maxMeanAboveFieldEdge * feet.count);
}

// Counts the columns between the goal's ends; robots may hide most of the feet.
bool goalHasFieldBelow(const GoalCandidate& c, const GoalFinderParams& p) {
  int columns = 0;
  int green = 0;
  for (const GoalColumn& column : c.columns) {
    if (column.u < c.box.left || column.u > c.box.right) continue;
    ++columns;
    green += column.green ? 1 : 0;
  }
  return green > 0 && green >= p.minFieldColumns * columns;
}

// A beacon that was not recognised has its pink right above or below.
bool goalHasNoPinkBeside(const Scene& scene, const GoalCandidate& c) {
  constexpr std::array<double, 3> kShares{0.15, 0.35, 0.55};  // of the height, away from it
  if (c.box.width() > kBeaconAspect * c.box.height()) return true;
  for (const double share : kShares) {
    const double away = 1.0 + share * c.box.height();
    for (const double v : {c.box.top - away, c.box.bottom + away}) {
      const PixelPoint at = scene.frame.toImage({c.box.middle(), v});
      if (Sampler::usable(at) && scene.sampler.classAt(at) == ColourClass::pink) return false;
    }
  }
  return true;
}

bool goalIsMeasured(const GoalCandidate& c) { return c.wallDistance > 0.0; }

bool goalHasWidth(const Scene& scene, const GoalCandidate& c, const GoalFinderParams& p) {
  const double seen = visibleWidth(scene, c);
  // Anything may show between two pairs of legs.
  if (c.left.hidden && c.right.hidden) return seen >= p.minHiddenWidth && seen <= p.maxVisibleWidth;
  const double min = c.left.open() || c.right.open() ? p.minCutWidth : p.minVisibleWidth;
  return seen >= min && seen <= p.maxVisibleWidth;
}

bool goalIsPart(const Scene& scene, const GoalCandidate& c, const GoalFinderParams& p) {
  return visibleWidth(scene, c) <= p.maxPartWidth && hasFirmFeet(scene, c, p);
}

bool goalIsNear(const GoalCandidate& c, const GoalFinderParams& p) {
  return c.wallDistance <= p.maxDistance;
}

void findGoals(const Scene& scene, const GoalFinderParams& params, VisionCounts& counts,
               Landmarks& landmarks, GoalGaps& gaps, JudgedGoals& judged) {
  const Landmarks beacons = landmarks;
  Finder finder{scene, params, beacons, counts, judged, {}};
  Likeliest best;
  for (const ColourClass colour : {ColourClass::blue, ColourClass::yellow}) {
    ScratchVector<Region, kMaxSeeds> groups;
    const Seeds seeds = seedsOf(scene, colour, beacons);
    if (colour == ColourClass::blue && !seeds.empty()) finder.carpet = carpetColour(scene);
    for (const Blob* seed : seeds) {
      const GoalCandidate group = grouped(scene, *seed, beacons);
      // Each part of a goal seeds the same group.
      const Region region{group.samples, group.box};
      const bool known = std::any_of(groups.begin(), groups.end(), [&region](const Region& other) {
        return areSame(region, other);
      });
      groups.push_back(region);
      if (!known) finder.consider(group, best);
      if (group.samples != seed->samples) finder.consider(alone(*seed), best);
    }
  }
  if (!best.found) return;
  landmarks.push_back(best.percept);
  findGaps(scene, best.candidate, best.shape, gaps);
}

}  // namespace kelpie::vision
