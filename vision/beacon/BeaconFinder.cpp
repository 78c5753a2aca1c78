// SPDX-License-Identifier: Apache-2.0
#include "vision/beacon/BeaconFinder.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "robot/core/ScratchVector.h"
#include "vision/ElevationDoubt.h"
#include "vision/Refusal.h"
#include "vision/beacon/BeaconFeet.h"
#include "vision/pixels/GroundRay.h"
#include "vision/pixels/SpanWalk.h"

namespace kelpie::vision {
namespace {

constexpr std::size_t kMaxCandidates = 12;

// Where to look for a pink band: in a pink blob, or next to a blue or yellow one that is no longer
// or wider than a band can be.
std::optional<PixelPoint> pinkStart(const Scene& scene, const Blob& blob, ImageDirection up) {
  constexpr double kMaxAspect = 2.5;  // of a band, either way
  if (blob.colour == ColourClass::pink) return blob.centre;
  if (blob.colour == ColourClass::orange) return std::nullopt;
  const double width = blob.box.width();
  const double height = blob.box.height();
  if (width > kMaxAspect * height || height > kMaxAspect * width) return std::nullopt;
  for (const ImageDirection direction : {up, -up}) {
    const EdgeHit edge = walkToEdge(scene.sampler, {blob.centre, direction, blob.colour, 1});
    const PixelPoint next = moved(edge.point, direction, std::max(2.0, 0.5 * edge.length));
    if (edge.cut || !Sampler::usable(next)) continue;
    if (scene.sampler.classAt(next) == ColourClass::pink) return next;
  }
  return std::nullopt;
}

// More pink blobs are clothes: then each place is walked to as if pink were there.
constexpr std::size_t kMaxPinkBoxes = 64;
using PinkBoxes = ScratchVector<LevelBox, kMaxPinkBoxes>;

PinkBoxes pinkBoxesOf(const BlobBuffer& blobs) {
  PinkBoxes boxes;
  for (const Blob& blob : blobs)
    if (blob.colour == ColourClass::pink) boxes.push_back(blob.box);
  return boxes;
}

// Whether pink is seen in line above or below a blob's middle where the walks of `pinkStart` end.
// Without any neither needs to be made: eighty in a frame with a badly known blue.
bool pinkInLine(const PinkBoxes& pinks, const Blob& blob) {
  constexpr double kMargin = 4.0;  // px, two lattice steps
  if (pinks.full()) return true;
  const double reach = 0.5 * blob.box.height() + kMargin;
  return std::any_of(pinks.begin(), pinks.end(), [&](const LevelBox& pink) {
    return blob.middle.u >= pink.left - kMargin && blob.middle.u <= pink.right + kMargin &&
           pink.bottom >= blob.box.top - reach && pink.top <= blob.box.bottom + reach;
  });
}

LandmarkKind kindOf(const BeaconCandidate& c) {
  if (c.partner == ColourClass::blue) {
    return c.pinkIsLower ? LandmarkKind::beaconBlueOnPink : LandmarkKind::beaconPinkOnBlue;
  }
  return c.pinkIsLower ? LandmarkKind::beaconYellowOnPink : LandmarkKind::beaconPinkOnYellow;
}

// The distance's error moves the place where the border between the bands is expected.
ElevationError elevationErrorOf(const Scene& scene, const BeaconCandidate& c,
                                const BeaconFinderParams& p) {
  const double above = kBandsBelowMiddle * bandHeight(scene) - scene.body.camera.position.z;
  const double pixel = p.edgeSd / focalLength(scene);
  const double share = kRootTwo * above / (2.0 * bandHeight(scene));
  return {Angle::rad(elevationError(scene, c)), pixel * pixel * (1.0 + share * share)};
}

LandmarkPercept perceptOf(const Scene& scene, const BeaconCandidate& c,
                          const BeaconFinderParams& p) {
  constexpr double kOwnVariance = 4.0;  // cm^2, however near
  const CameraPose& camera = scene.body.camera;
  const GroundRay ray = groundRayThrough(camera, c.middle);
  const Point2<Robot> place = placeAt(camera, ray, c.distance);
  const double height = (c.topCut || c.bottomCut ? 1.0 : 2.0) * bandHeight(scene);
  LandmarkPercept percept;
  percept.kind = kindOf(c);
  percept.distance = place.norm();
  percept.heading = bearing(place);
  percept.elevation = Angle::rad(maths::atan(ray.slope));
  percept.distanceVariance =
      maths::square(sizeSd(camera, c.distance, height, p.edgeSd)) + kOwnVariance;
  percept.headingVariance = maths::square(p.headingSd.rad());
  percept.elevationError = elevationErrorOf(scene, c, p);
  percept.leftEdge = percept.heading;
  percept.rightEdge = percept.heading;
  const double half = 0.5 * c.width;
  percept.box = {std::min(c.top.x, c.bottom.x) - half, std::min(c.top.y, c.bottom.y),
                 std::max(c.top.x, c.bottom.x) + half, std::max(c.top.y, c.bottom.y)};
  percept.leftEdgeCut = percept.box.left <= kUsableLeft + 1;
  percept.rightEdgeCut = percept.box.right >= kUsableRight - 1;
  return percept;
}

// What every beacon passes, whatever hides or cuts it; all else is for the log odds.
bool mayBeBeacon(const Scene& scene, const BeaconCandidate& c, const BeaconFinderParams& p,
                 VisionCounts& counts) {
  const auto check = [&counts](bool keep, Refusal reason) {
    if (!keep) refuse(counts, reason);
    return keep;
  };
  return check(beaconHasPartner(c), Refusal::beaconNoPartner) &&
         check(beaconIsLarge(c, p), Refusal::beaconTooSmall) &&
         check(beaconReachesHorizon(scene, c, p), Refusal::beaconBelowHorizon) &&
         check(beaconIsNear(c, p), Refusal::beaconTooFar) &&
         check(beaconHeightFitsSize(scene, c, p), Refusal::beaconElevation) &&
         check(beaconHasNoCarpetBelow(scene, c), Refusal::beaconNoWhiteBelow);
}

// Beacons stand at most 20 cm inside the carpet's edge, but for a pixel.
bool standsAtFieldEdge(const BeaconFacts& facts) {
  constexpr double kMaxFootBelowEdge = 0.9;  // bands
  return facts.footBelowEdge <= kMaxFootBelowEdge + 1.0 / std::max(facts.band, 1.0);
}

bool insideBeacon(const Landmarks& landmarks, PixelPoint p) {
  return std::any_of(landmarks.begin(), landmarks.end(), [p](const LandmarkPercept& l) {
    return p.x >= l.box.left && p.x <= l.box.right && p.y >= l.box.top && p.y <= l.box.bottom;
  });
}

bool overlap(const PixelBox& a, const PixelBox& b) {
  return a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom;
}

// One percept of each kind and in each place: the one that is most likely a beacon.
struct Found {
  Landmarks landmarks;
  std::array<double, kMaxLandmarks> logOddsAgainst{};

  void keep(const JudgedBeacon& beacon) {
    for (std::size_t i = 0; i < landmarks.size(); ++i) {
      if (landmarks[i].kind != beacon.percept.kind &&
          !overlap(landmarks[i].box, beacon.percept.box))
        continue;
      if (beacon.logOddsAgainst >= logOddsAgainst[i]) return;
      landmarks[i] = beacon.percept;
      logOddsAgainst[i] = beacon.logOddsAgainst;
      return;
    }
    logOddsAgainst[landmarks.size()] = beacon.logOddsAgainst;
    landmarks.push_back(beacon.percept);
  }
};

struct Finder {
  const Scene& scene;
  const BeaconFinderParams& params;
  VisionCounts& counts;
  JudgedBeacons& judged;
  Found found;

  void judge(BeaconCandidate c) {
    measure(scene, params, c);
    if (!mayBeBeacon(scene, c, params, counts)) return;
    const BeaconFacts facts = beaconFacts(scene, c);
    if (!standsAtFieldEdge(facts)) {
      refuse(counts, Refusal::beaconOffFieldEdge);
      return;
    }
    const JudgedBeacon beacon{perceptOf(scene, c, params), facts, logOddsAgainst(facts)};
    judged.push_back(beacon);
    if (beacon.logOddsAgainst <= params.maxLogOddsAgainst)
      found.keep(beacon);
    else
      refuse(counts, Refusal::beaconUnlikely);
  }
};

}  // namespace

bool beaconHasPartner(const BeaconCandidate& c) { return c.partner != ColourClass::none; }

// One pixel is enough to tell the colour of a band that the image border cuts.
bool beaconIsLarge(const BeaconCandidate& c, const BeaconFinderParams& p) {
  constexpr double kCutAllowance = 1.5;  // of what shows of a band that the image cuts
  const double upper = c.topCut ? kCutAllowance * c.upper + 1.0 : c.upper;
  const double lower = c.bottomCut ? kCutAllowance * c.lower + 1.0 : c.lower;
  return upper >= p.minBand && lower >= p.minBand;
}

bool beaconReachesHorizon(const Scene& scene, const BeaconCandidate& c,
                          const BeaconFinderParams& p) {
  return belowHorizon(scene, c.middle) <= p.maxBelowHorizon + rowSlack(scene);
}

bool beaconHeightFitsSize(const Scene& scene, const BeaconCandidate& c,
                          const BeaconFinderParams& p) {
  return std::fabs(settledElevationError(scene, c)) <= p.elevationError.rad();
}

bool beaconHasNoCarpetBelow(const Scene& scene, const BeaconCandidate& c) {
  constexpr std::array<double, 3> kBandsDown{0.5, 1.0, 1.5};
  int green = 0;
  for (const double bands : kBandsDown) {
    const PixelPoint at = moved(c.bottom, scene.frame.up(), -bands * bandOf(c));
    if (!Sampler::usable(at)) break;
    green += scene.sampler.classAt(at) == ColourClass::green ? 1 : 0;
  }
  return green < 2;
}

bool beaconIsNear(const BeaconCandidate& c, const BeaconFinderParams& p) {
  return c.distance <= p.maxDistance;
}

void findBeacons(const Scene& scene, const BeaconFinderParams& params, VisionCounts& counts,
                 Landmarks& landmarks, JudgedBeacons& judged) {
  Finder finder{scene, params, counts, judged, {}};
  for (const BeaconFoot& foot : findBeaconFeet(scene)) finder.judge(beaconFromFoot(scene, foot));
  const PinkBoxes pinks = pinkBoxesOf(scene.blobs);
  std::size_t candidates = 0;
  for (const Blob& blob : scene.blobs) {
    // What is too small to begin a beacon need not be asked what is beside it: specks of clothes
    // and of a badly known blue took 20 to 50 k instructions a frame.
    const bool small = static_cast<double>(blob.samples) < params.minSamples;
    if (blob.colour != ColourClass::pink && (small || !pinkInLine(pinks, blob))) continue;
    const auto start = pinkStart(scene, blob, scene.frame.up());
    if (!start || insideBeacon(finder.found.landmarks, *start)) continue;
    if (small || candidates == kMaxCandidates) {
      refuse(counts, Refusal::beaconTooSmall);
      continue;
    }
    ++candidates;
    for (const bool pinkIsLower : {true, false})
      finder.judge(beaconFromPink(scene, *start, pinkIsLower));
  }
  for (const LandmarkPercept& landmark : finder.found.landmarks) landmarks.push_back(landmark);
}

}  // namespace kelpie::vision
