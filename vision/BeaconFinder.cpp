// SPDX-License-Identifier: Apache-2.0
#include "vision/BeaconFinder.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "vision/Refusal.h"
#include "vision/Sight.h"

namespace kelpie::vision {
namespace {

constexpr double kBandHeight = 10.0;  // cm; four bands, the upper two coloured (facts-2005 1)
constexpr double kBeaconRadius = 5.0;
constexpr double kTopHeight = 40.0;
constexpr std::size_t kMaxCandidates = 12;

PixelPoint moved(PixelPoint p, ImageUp up, double length) {
  return {p.x + length * up.dx, p.y + length * up.dy};
}

ImageUp reversed(ImageUp d) { return {-d.dx, -d.dy}; }

struct Band {
  ColourClass colour = ColourClass::none;
  EdgeHit pinkEdge;
  PixelPoint end;
  bool cut = false;
  double height = 0.0;
};

// Looks past the pink band's edge for blue or yellow; up to two mixed pixels lie between.
Band bandBeyond(const Scene& scene, PixelPoint pink, ImageUp direction) {
  Band band;
  band.pinkEdge =
      walkToEdge(scene.sampler, {pink, direction.dx, direction.dy, ColourClass::pink, 1});
  if (band.pinkEdge.cut) return band;
  for (const double gap : {1.5, 2.5}) {
    const PixelPoint start = moved(band.pinkEdge.point, direction, gap);
    if (!Sampler::usable(start)) return band;
    const ColourClass colour = scene.sampler.classAt(start);
    if (colour != ColourClass::blue && colour != ColourClass::yellow) continue;
    const EdgeHit far = walkToEdge(scene.sampler, {start, direction.dx, direction.dy, colour, 1});
    band.colour = colour;
    band.end = far.point;
    band.cut = far.cut;
    band.height = far.length + gap;
    return band;
  }
  return band;
}

struct Width {
  double value = 0.0;
  bool cut = false;
};

Width widthAt(const Scene& scene, ImageUp up, PixelPoint at, ColourClass colour) {
  const ImageUp right{-up.dy, up.dx};
  const EdgeHit r = walkToEdge(scene.sampler, {at, right.dx, right.dy, colour, 1});
  const EdgeHit l = walkToEdge(scene.sampler, {at, -right.dx, -right.dy, colour, 1});
  return {r.length + l.length, r.cut || l.cut};
}

// Of both bands; the narrower counts, because clothes or a goal may touch the other.
void measureWidth(const Scene& scene, ImageUp up, BeaconCandidate& c) {
  const double half = 0.5 * (c.pinkIsLower ? c.upper : -c.lower);
  const Width pink = widthAt(scene, up, c.pink, ColourClass::pink);
  const Width partner = widthAt(scene, up, moved(c.middle, up, half), c.partner);
  const bool usePink = pink.value <= partner.value || partner.value < 1.0;
  c.width = usePink ? pink.value : partner.value;
  c.widthCut = pink.cut || partner.cut;
}

// Two of the heights 40, 30 and 20 cm that lie inside the image, as far apart as possible.
double measureDistance(const Scene& scene, const BeaconCandidate& c) {
  const CameraPose& camera = scene.body.camera;
  const double high = sightOf(camera, c.topCut ? c.middle : c.top).slope;
  const double low = sightOf(camera, c.bottomCut ? c.middle : c.bottom).slope;
  const double height = c.topCut || c.bottomCut ? kBandHeight : 2.0 * kBandHeight;
  // The bands' front is measured, the axis is meant.
  return high - low > 1e-4 ? height / (high - low) + kBeaconRadius : 1e6;
}

BeaconCandidate measured(const Scene& scene, PixelPoint pink, ImageUp up) {
  BeaconCandidate c;
  c.pink = pink;
  const Band above = bandBeyond(scene, pink, up);
  const Band below = bandBeyond(scene, pink, reversed(up));
  c.bothSides = above.colour != ColourClass::none && below.colour != ColourClass::none;
  c.pinkIsLower = above.colour != ColourClass::none;
  const Band& partner = c.pinkIsLower ? above : below;
  const EdgeHit& far = c.pinkIsLower ? below.pinkEdge : above.pinkEdge;
  c.partner = partner.colour;
  c.middle = partner.pinkEdge.point;
  c.top = c.pinkIsLower ? partner.end : far.point;
  c.bottom = c.pinkIsLower ? far.point : partner.end;
  c.topCut = c.pinkIsLower ? partner.cut : far.cut;
  c.bottomCut = c.pinkIsLower ? far.cut : partner.cut;
  const double pinkHeight = above.pinkEdge.length + below.pinkEdge.length;
  c.upper = c.pinkIsLower ? partner.height : pinkHeight;
  c.lower = c.pinkIsLower ? pinkHeight : partner.height;
  if (c.partner == ColourClass::none) return c;
  c.distance = measureDistance(scene, c);
  measureWidth(scene, up, c);
  return c;
}

// Where to look for a pink band: in a pink blob, or next to a blue or yellow one that is no longer
// or wider than a band can be.
std::optional<PixelPoint> pinkStart(const Scene& scene, const Blob& blob, ImageUp up) {
  if (blob.colour == ColourClass::pink) return blob.centre;
  if (blob.colour == ColourClass::orange) return std::nullopt;
  const double width = blob.box.width();
  const double height = blob.box.height();
  if (width > 2.5 * height || height > 2.5 * width) return std::nullopt;
  for (const ImageUp direction : {up, reversed(up)}) {
    const EdgeHit edge =
        walkToEdge(scene.sampler, {blob.centre, direction.dx, direction.dy, blob.colour, 1});
    const PixelPoint next = moved(edge.point, direction, std::max(2.0, 0.5 * edge.length));
    if (edge.cut || !Sampler::usable(next)) continue;
    if (scene.sampler.classAt(next) == ColourClass::pink) return next;
  }
  return std::nullopt;
}

LandmarkKind kindOf(const BeaconCandidate& c) {
  if (c.partner == ColourClass::blue) {
    return c.pinkIsLower ? LandmarkKind::beaconBlueOnPink : LandmarkKind::beaconPinkOnBlue;
  }
  return c.pinkIsLower ? LandmarkKind::beaconYellowOnPink : LandmarkKind::beaconPinkOnYellow;
}

LandmarkPercept perceptOf(const Scene& scene, const BeaconCandidate& c, const BeaconParams& p) {
  const CameraPose& camera = scene.body.camera;
  const Sight sight = sightOf(camera, c.middle);
  const Point2<Robot> place = placeAt(camera, sight, c.distance);
  const double height = c.topCut || c.bottomCut ? kBandHeight : 2.0 * kBandHeight;
  LandmarkPercept percept;
  percept.kind = kindOf(c);
  percept.distance = place.norm();
  percept.heading = bearing(place);
  percept.elevation = Angle::rad(maths::atan(sightOf(camera, c.middle).slope));
  percept.distanceVariance = maths::square(sizeSd(c.distance, height, p.edgeSd)) + 4.0;
  percept.headingVariance = maths::square(p.headingSd.rad());
  percept.leftEdge = percept.heading;
  percept.rightEdge = percept.heading;
  const double half = 0.5 * c.width;
  percept.box = {std::min(c.top.x, c.bottom.x) - half, std::min(c.top.y, c.bottom.y),
                 std::max(c.top.x, c.bottom.x) + half, std::max(c.top.y, c.bottom.y)};
  percept.leftEdgeCut = percept.box.left <= kUsableLeft + 1;
  percept.rightEdgeCut = percept.box.right >= kUsableRight - 1;
  return percept;
}

bool accepted(const Scene& scene, const BeaconCandidate& c, const BeaconParams& p,
              VisionCounts& counts) {
  const auto check = [&counts](bool keep, Refusal reason) {
    if (!keep) refuse(counts, reason);
    return keep;
  };
  return check(beaconHasPartner(c), Refusal::beaconNoPartner) &&
         check(beaconHasOnePartner(c), Refusal::beaconBothSides) &&
         check(std::min(c.upper, c.lower) >= p.minBand, Refusal::beaconTooSmall) &&
         check(beaconBandsAreEqual(c, p), Refusal::beaconSizeRatio) &&
         check(beaconBandIsSquare(c, p), Refusal::beaconAspect) &&
         check(beaconReachesHorizon(scene, c, p), Refusal::beaconBelowHorizon) &&
         check(beaconIsNear(c, p), Refusal::beaconTooFar) &&
         check(beaconHeightFitsSize(scene, c, p), Refusal::beaconElevation) &&
         check(beaconHasWhiteBelow(scene, c, p), Refusal::beaconNoWhiteBelow);
}

// One percept of each kind: the larger of two is kept.
void keep(Landmarks& landmarks, const LandmarkPercept& percept) {
  for (LandmarkPercept& known : landmarks) {
    if (known.kind != percept.kind) continue;
    if (percept.distance < known.distance) known = percept;
    return;
  }
  landmarks.push_back(percept);
}

}  // namespace

bool beaconHasPartner(const BeaconCandidate& c) { return c.partner != ColourClass::none; }

bool beaconHasOnePartner(const BeaconCandidate& c) { return !c.bothSides; }

bool beaconBandsAreEqual(const BeaconCandidate& c, const BeaconParams& p) {
  const double small = std::min(c.upper, c.lower);
  const double large = std::max(c.upper, c.lower);
  // A band that the image border cuts may be any shorter; small bands are uncertain by a pixel.
  if (c.topCut || c.bottomCut) return true;
  return large <= p.maxRatio * small + 1.0;
}

bool beaconBandIsSquare(const BeaconCandidate& c, const BeaconParams& p) {
  const double height = c.pinkIsLower ? c.lower : c.upper;
  const bool cut = c.pinkIsLower ? c.bottomCut : c.topCut;
  const bool tooWide = !cut && c.width > p.maxAspect * height + 1.0;
  const bool tooTall = !c.widthCut && height > p.maxAspect * c.width + 1.0;
  const double cm = c.width * (c.distance - kBeaconRadius) / body::kFocalLength;
  const double pixel = c.distance / body::kFocalLength;
  const bool wrongWidth = cm > p.maxWidth + pixel || (!c.widthCut && cm < p.minWidth - pixel);
  return !tooWide && !tooTall && !wrongWidth;
}

bool beaconReachesHorizon(const Scene& scene, const BeaconCandidate& c, const BeaconParams& p) {
  return belowHorizon(scene, c.middle) <= p.maxBelowHorizon;
}

// The lower two bands are white; three points within the first of them. Beyond the image: keep.
bool beaconHasWhiteBelow(const Scene& scene, const BeaconCandidate& c, const BeaconParams& p) {
  if (c.bottomCut) return true;
  const ImageUp down = reversed(scene.level.up());
  const double band = 0.5 * (c.upper + c.lower);
  int white = 0;
  for (const double share : {0.35, 0.6, 0.85}) {
    const PixelPoint at = moved(c.bottom, down, share * band + 0.5);
    if (!Sampler::usable(at)) return true;
    const ColourClass colour = scene.sampler.classAt(at);
    if (colour == ColourClass::white || colour == ColourClass::grey) ++white;
  }
  return white >= p.minWhiteProbes;
}

bool beaconHeightFitsSize(const Scene& scene, const BeaconCandidate& c, const BeaconParams& p) {
  const double expected =
      (kTopHeight - kBandHeight - scene.body.camera.position.z) / (c.distance - kBeaconRadius);
  const double seen = sightOf(scene.body.camera, c.middle).slope;
  return std::fabs(maths::atan(expected) - maths::atan(seen)) <= p.elevationError.rad();
}

bool beaconIsNear(const BeaconCandidate& c, const BeaconParams& p) {
  return c.distance <= p.maxDistance;
}

void findBeacons(const Scene& scene, const BeaconParams& params, VisionCounts& counts,
                 Landmarks& landmarks) {
  const ImageUp up = scene.level.up();
  std::size_t candidates = 0;
  for (const Blob& blob : scene.blobs) {
    const auto start = pinkStart(scene, blob, up);
    if (!start) continue;
    if (static_cast<double>(blob.samples) < params.minSamples || candidates == kMaxCandidates) {
      refuse(counts, Refusal::beaconTooSmall);
      continue;
    }
    ++candidates;
    const BeaconCandidate candidate = measured(scene, *start, up);
    if (!accepted(scene, candidate, params, counts)) continue;
    keep(landmarks, perceptOf(scene, candidate, params));
  }
}

}  // namespace kelpie::vision
