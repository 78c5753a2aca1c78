// SPDX-License-Identifier: Apache-2.0
#include "vision/beacon/BeaconFinder.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "vision/Refusal.h"
#include "vision/beacon/BeaconFeet.h"
#include "vision/pixels/GroundRay.h"
#include "vision/pixels/SpanWalk.h"

namespace kelpie::vision {
namespace {

// Four bands of one height, the upper two coloured (facts-2005 section 1).
double bandHeight(const Scene& scene) { return 0.25 * scene.field.beaconHeight; }

constexpr std::size_t kMaxCandidates = 12;
constexpr int kMinWhite = 4;  // half pixels of the white part that must show

struct Band {
  ColourClass colour = ColourClass::none;
  EdgeHit edge;      // where the band before ends
  PixelPoint start;  // inside
  PixelPoint end;
  bool cut = false;
  double height = 0.0;
};

bool isPartner(ColourClass c) { return c == ColourClass::blue || c == ColourClass::yellow; }

// The band that follows past the edge of the one that `from` is in: a partner colour after pink,
// pink after a partner colour. Up to two mixed pixels lie between.
Band bandBeyond(const Scene& scene, PixelPoint from, ColourClass inside, ImageDirection direction) {
  Band band;
  band.edge = walkToEdge(scene.sampler, {from, direction, inside, 1});
  if (band.edge.cut) return band;
  for (const double gap : {1.5, 2.5}) {
    const PixelPoint start = moved(band.edge.point, direction, gap);
    if (!Sampler::usable(start)) return band;
    const ColourClass colour = scene.sampler.classAt(start);
    if (inside == ColourClass::pink ? !isPartner(colour) : colour != ColourClass::pink) continue;
    const EdgeHit far = walkToEdge(scene.sampler, {start, direction, colour, 1});
    band.colour = colour;
    band.start = start;
    band.end = far.point;
    band.cut = far.cut;
    band.height = far.length + gap;
    return band;
  }
  return band;
}

// The height of a band that the image shows whole, in px.
double bandOf(const BeaconCandidate& c) {
  return c.topCut ? c.lower : c.bottomCut ? c.upper : 0.5 * (c.upper + c.lower);
}

struct Width {
  double value = 0.0;
  double offset = 0.0;  // px to the right, of its middle from where it was measured
  bool cut = false;
};

Width widthAt(const Scene& scene, PixelPoint at, ColourClass colour) {
  const ImageDirection right = scene.frame.right();
  const EdgeHit r = walkToEdge(scene.sampler, {at, right, colour, 1});
  const EdgeHit l = walkToEdge(scene.sampler, {at, -right, colour, 1});
  return {r.length + l.length, 0.5 * (r.length - l.length), r.cut || l.cut};
}

// The narrower of two counts, because clothes or a goal may touch the other; one that the image
// border does not cut before one that it does.
Width better(const Width& a, const Width& b) {
  if (a.value < 1.0 || b.value < 1.0) return a.value < 1.0 ? b : a;
  if (a.cut != b.cut) return a.cut ? b : a;
  return b.value < a.value ? b : a;
}

// Measures the width of both bands and of the white below, and moves the candidate's axis to its
// middle.
void measureWidth(const Scene& scene, BeaconCandidate& c) {
  const ImageDirection up = scene.frame.up();
  const PixelPoint high = moved(c.middle, up, 0.5 * c.upper);
  const PixelPoint low = moved(c.middle, up, -0.5 * c.lower);
  const PixelPoint white = moved(c.bottom, up, -0.8 * c.lower);
  const Width ofUpper = widthAt(scene, high, c.pinkIsLower ? c.partner : ColourClass::pink);
  const Width ofLower = widthAt(scene, low, c.pinkIsLower ? ColourClass::pink : c.partner);
  Width best = better(ofUpper, ofLower);
  if (c.onWhite && Sampler::usable(white) && scene.sampler.classAt(white) == ColourClass::white) {
    const Width foot = widthAt(scene, white, ColourClass::white);
    if (foot.value >= 0.7 * best.value) best = better(best, foot);
  }
  c.width = best.value;
  c.widest = std::max(ofUpper.value, ofLower.value);
  c.widthCut = best.cut;
  if (best.cut) return;
  for (PixelPoint* point : {&c.top, &c.middle, &c.bottom})
    *point = moved(*point, scene.frame.right(), best.offset);
}

// A band much higher than the other runs on into something of its colour: its end is not known.
// Where two unequal bands stand over something that is not white, a robot or the ball hides the
// lower one.
void forgetMergedEnds(BeaconCandidate& c, const BeaconFinderParams& p) {
  if (!c.onWhite) {
    c.bottomCut = c.bottomCut || c.upper > p.maxRatio * c.lower + 1.0;
    return;
  }
  if (c.upper > p.maxRatio * c.lower + 1.0) {
    c.upper = c.lower;
    c.topCut = true;
  }
}

// Two of the ends of the coloured bands (40, 30 and 20 cm) that lie inside the image, as far apart
// as possible.
double measureDistance(const Scene& scene, const BeaconCandidate& c) {
  const CameraPose& camera = scene.body.camera;
  const double high = groundRayThrough(camera, c.topCut ? c.middle : c.top).slope;
  const double low = groundRayThrough(camera, c.bottomCut ? c.middle : c.bottom).slope;
  const double height = (c.topCut || c.bottomCut ? 1.0 : 2.0) * bandHeight(scene);
  // The front of the bands is measured, the percept is the axis.
  return high - low > 1e-4 ? height / (high - low) + scene.field.beaconRadius : 1e6;
}

// Elevation of the bands' border less that of 30 cm at the distance that their size tells, rad.
double elevationError(const Scene& scene, const BeaconCandidate& c) {
  const double expected = (3.0 * bandHeight(scene) - scene.body.camera.position.z) /
                          (c.distance - scene.field.beaconRadius);
  return maths::atan(groundRayThrough(scene.body.camera, c.middle).slope) - maths::atan(expected);
}

// The candidate at a pink point, its partner colour on one side.
BeaconCandidate fromPink(const Scene& scene, PixelPoint pink, bool pinkIsLower) {
  const ImageDirection up = pinkIsLower ? scene.frame.up() : -scene.frame.up();
  BeaconCandidate c;
  c.pink = pink;
  const Band partner = bandBeyond(scene, pink, ColourClass::pink, up);
  if (partner.colour == ColourClass::none) return c;
  const EdgeHit far = walkToEdge(scene.sampler, {pink, -up, ColourClass::pink, 1});
  c.pinkIsLower = pinkIsLower;
  c.partner = partner.colour;
  c.middle = partner.edge.point;
  c.top = pinkIsLower ? partner.end : far.point;
  c.bottom = pinkIsLower ? far.point : partner.end;
  c.topCut = pinkIsLower ? partner.cut : far.cut;
  c.bottomCut = pinkIsLower ? far.cut : partner.cut;
  const double pinkHeight = partner.edge.length + far.length;
  c.upper = pinkIsLower ? partner.height : pinkHeight;
  c.lower = pinkIsLower ? pinkHeight : partner.height;
  return c;
}

// The candidate upwards from its white part.
BeaconCandidate fromFoot(const Scene& scene, const BeaconFoot& foot) {
  const ImageDirection up = scene.frame.up();
  BeaconCandidate c;
  c.onWhite = true;
  const PixelPoint from = scene.frame.toImage({0.5 * (foot.left + foot.right), foot.lowest});
  if (!Sampler::usable(from) || scene.sampler.classAt(from) != foot.colour) return c;
  const EdgeHit low = walkToEdge(scene.sampler, {from, -up, foot.colour, 1});
  const Band above = bandBeyond(scene, from, foot.colour, up);
  if (above.colour == ColourClass::none) return c;
  c.pinkIsLower = foot.colour == ColourClass::pink;
  c.partner = c.pinkIsLower ? above.colour : foot.colour;
  c.pink = c.pinkIsLower ? from : above.start;
  c.bottom = low.point;
  c.bottomCut = low.cut;
  c.middle = above.edge.point;
  c.top = above.end;
  c.topCut = above.cut;
  c.lower = low.length + above.edge.length;
  c.upper = above.height;
  return c;
}

void measure(const Scene& scene, const BeaconFinderParams& p, BeaconCandidate& c) {
  if (c.partner == ColourClass::none) return;
  forgetMergedEnds(c, p);
  measureWidth(scene, c);
  c.distance = measureDistance(scene, c);
  c.sure = std::fabs(elevationError(scene, c)) <= p.sureElevation.rad();
}

// Where to look for a pink band: in a pink blob, or next to a blue or yellow one that is no longer
// or wider than a band can be.
std::optional<PixelPoint> pinkStart(const Scene& scene, const Blob& blob, ImageDirection up) {
  if (blob.colour == ColourClass::pink) return blob.centre;
  if (blob.colour == ColourClass::orange) return std::nullopt;
  const double width = blob.box.width();
  const double height = blob.box.height();
  if (width > 2.5 * height || height > 2.5 * width) return std::nullopt;
  for (const ImageDirection direction : {up, -up}) {
    const EdgeHit edge = walkToEdge(scene.sampler, {blob.centre, direction, blob.colour, 1});
    const PixelPoint next = moved(edge.point, direction, std::max(2.0, 0.5 * edge.length));
    if (edge.cut || !Sampler::usable(next)) continue;
    if (scene.sampler.classAt(next) == ColourClass::pink) return next;
  }
  return std::nullopt;
}

struct White {
  int probes = 0;
  int white = 0;
  double share() const { return probes > 0 ? static_cast<double>(white) / probes : 0.5; }
};

// How much of the two bands below the coloured part is white, as far as the image shows them.
White whiteBelow(const Scene& scene, const BeaconCandidate& c) {
  const double band = bandOf(c);
  White all;
  for (double down = 0.2 * band; down < 1.9 * band; down += 0.5) {
    const PixelPoint at = moved(c.bottom, scene.frame.up(), -down);
    if (!Sampler::usable(at)) break;
    const ColourClass colour = scene.sampler.classAt(at);
    ++all.probes;
    all.white += colour == ColourClass::white || colour == ColourClass::grey ? 1 : 0;
  }
  return all;
}

// How far below the field edge its foot should be, in px: three bands below the border between the
// colours.
double footBelowEdge(const Scene& scene, const BeaconCandidate& c) {
  return belowFieldEdge(scene, moved(c.middle, scene.frame.up(), -3.0 * bandOf(c)));
}

// How unlike a beacon it is: among several of one kind the one with the least misfit is kept.
double misfit(const Scene& scene, const BeaconCandidate& c) {
  const double height = std::max(1.0, std::min(c.upper, c.lower));
  const double bands = c.topCut || c.bottomCut ? 0.3 : std::fabs(maths::log(c.upper / c.lower));
  const double aspect = std::fabs(maths::log(std::max(c.width, 0.5) / height));
  return bands + aspect + 10.0 * std::fabs(elevationError(scene, c)) + (c.onWhite ? 0.0 : 0.3);
}

LandmarkKind kindOf(const BeaconCandidate& c) {
  if (c.partner == ColourClass::blue) {
    return c.pinkIsLower ? LandmarkKind::beaconBlueOnPink : LandmarkKind::beaconPinkOnBlue;
  }
  return c.pinkIsLower ? LandmarkKind::beaconYellowOnPink : LandmarkKind::beaconPinkOnYellow;
}

LandmarkPercept perceptOf(const Scene& scene, const BeaconCandidate& c,
                          const BeaconFinderParams& p) {
  const CameraPose& camera = scene.body.camera;
  const GroundRay ray = groundRayThrough(camera, c.middle);
  const Point2<Robot> place = placeAt(camera, ray, c.distance);
  const double height = (c.topCut || c.bottomCut ? 1.0 : 2.0) * bandHeight(scene);
  LandmarkPercept percept;
  percept.kind = kindOf(c);
  percept.distance = place.norm();
  percept.heading = bearing(place);
  percept.elevation = Angle::rad(maths::atan(groundRayThrough(camera, c.middle).slope));
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

bool accepted(const Scene& scene, const BeaconCandidate& c, const BeaconFinderParams& p,
              VisionCounts& counts) {
  const auto check = [&counts](bool keep, Refusal reason) {
    if (!keep) refuse(counts, reason);
    return keep;
  };
  return check(beaconHasPartner(c), Refusal::beaconNoPartner) &&
         check(beaconIsLarge(c, p), Refusal::beaconTooSmall) &&
         check(beaconBandsAreEqual(c, p), Refusal::beaconSizeRatio) &&
         check(beaconBandIsSquare(c, p), Refusal::beaconAspect) &&
         check(beaconBandsStandAlone(c, p), Refusal::beaconMerged) &&
         check(beaconReachesHorizon(scene, c, p), Refusal::beaconBelowHorizon) &&
         check(beaconIsNear(c, p), Refusal::beaconTooFar) &&
         check(beaconHeightFitsSize(scene, c, p), Refusal::beaconElevation) &&
         check(beaconHasWhiteBelow(scene, c, p), Refusal::beaconNoWhiteBelow) &&
         check(beaconIsInImage(c), Refusal::beaconCut) &&
         check(beaconStandsAtFieldEdge(scene, c, p), Refusal::beaconOffFieldEdge) &&
         check(beaconStandsOnField(scene, c), Refusal::beaconNoField) &&
         check(weakCues(scene, c) <= p.maxWeakCues, Refusal::beaconUnlikely);
}

bool insideBeacon(const Landmarks& landmarks, PixelPoint p) {
  return std::any_of(landmarks.begin(), landmarks.end(), [p](const LandmarkPercept& l) {
    return p.x >= l.box.left && p.x <= l.box.right && p.y >= l.box.top && p.y <= l.box.bottom;
  });
}

bool overlap(const PixelBox& a, const PixelBox& b) {
  return a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom;
}

// One percept of each kind and in each place: the one more like a beacon.
struct Found {
  Landmarks landmarks;
  std::array<double, 8> misfit{};

  void keep(const LandmarkPercept& percept, double unlike) {
    for (std::size_t i = 0; i < landmarks.size(); ++i) {
      if (landmarks[i].kind != percept.kind && !overlap(landmarks[i].box, percept.box)) continue;
      if (unlike >= misfit[i]) return;
      landmarks[i] = percept;
      misfit[i] = unlike;
      return;
    }
    misfit[landmarks.size()] = unlike;
    landmarks.push_back(percept);
  }
};

}  // namespace

bool beaconHasPartner(const BeaconCandidate& c) { return c.partner != ColourClass::none; }

// One pixel is enough to tell the colour of a band that the image border cuts.
bool beaconIsLarge(const BeaconCandidate& c, const BeaconFinderParams& p) {
  const double upper = c.topCut ? 1.5 * c.upper + 1.0 : c.upper;
  const double lower = c.bottomCut ? 1.5 * c.lower + 1.0 : c.lower;
  return upper >= p.minBand && lower >= p.minBand;
}

bool beaconBandsAreEqual(const BeaconCandidate& c, const BeaconFinderParams& p) {
  const double small = std::min(c.upper, c.lower);
  const double large = std::max(c.upper, c.lower);
  // A band that the image border cuts may be any shorter; small bands are uncertain by a pixel.
  if (c.topCut || c.bottomCut) return true;
  return large <= p.maxRatio * small + 1.0;
}

// A band is 10 cm wide and high; the border may cut a third of its width.
bool beaconBandIsSquare(const BeaconCandidate& c, const BeaconFinderParams& p) {
  const double height = bandOf(c);
  const double aspect = c.sure ? p.maxSureAspect : p.maxAspect;
  const bool wide = c.width > aspect * height + 1.0;
  const double seen = c.widthCut ? c.width / 0.6 : c.width;
  const bool narrow = aspect * seen + 1.0 < height;
  return !wide && !narrow;
}

// Pink on a coat is on far more of the coat's colour. A goal or trousers behind a beacon are far
// wider too, but then the white below tells it, if both bands' ends show.
bool beaconBandsStandAlone(const BeaconCandidate& c, const BeaconFinderParams& p) {
  if (c.onWhite && !c.topCut) return true;
  const bool endUnknown = !c.onWhite && (c.topCut || c.bottomCut);
  return c.widest <= (endUnknown ? p.maxCutBandWidths : p.maxBandWidths) * c.width;
}

bool beaconReachesHorizon(const Scene& scene, const BeaconCandidate& c,
                          const BeaconFinderParams& p) {
  return belowHorizon(scene, c.middle) <= p.maxBelowHorizon;
}

// The lower two bands are white, as far as the image shows them. Some of it must show where the
// height does not fit the size well.
bool beaconHasWhiteBelow(const Scene& scene, const BeaconCandidate& c,
                         const BeaconFinderParams& p) {
  const White white = whiteBelow(scene, c);
  if (c.sure) return c.bottomCut || white.share() >= p.minWhiteShare;
  return white.probes >= kMinWhite && white.share() >= p.minUnsureWhiteShare;
}

// Beacons stand at the carpet's edge.
bool beaconStandsAtFieldEdge(const Scene& scene, const BeaconCandidate& c,
                             const BeaconFinderParams& p) {
  if (scene.fieldEdges.empty()) return true;
  const double below = footBelowEdge(scene, c);
  return below >= -p.maxFootAboveEdge && below <= p.maxFootBelowEdge * bandOf(c) + 1.0;
}

// What the image's border cuts above or below must show its whole width.
bool beaconIsInImage(const BeaconCandidate& c) {
  const int cuts = (c.topCut ? 1 : 0) + (c.bottomCut ? 1 : 0) + (c.widthCut ? 1 : 0);
  return cuts < 2 || c.sure;
}

// Where its 20 cm of white end the carpet begins, or a robot or a ball hides it.
bool beaconStandsOnField(const Scene& scene, const BeaconCandidate& c) {
  if (c.bottomCut) return true;
  const double band = bandOf(c);
  const double end = 3.2 * band + 5.0;
  int strange = 0;
  for (double down = 0.7 * band; down < end; down += 1.0) {
    const PixelPoint at = moved(c.bottom, scene.frame.up(), -down);
    if (!Sampler::usable(at)) return true;
    const ColourClass colour = scene.sampler.classAt(at);
    if (colour == ColourClass::green) return true;
    const bool other = colour == ColourClass::none || colour == ColourClass::blue ||
                       colour == ColourClass::yellow || colour == ColourClass::pink;
    strange = other ? strange + 1 : 0;
    if (strange > 3.0 + 0.3 * band) return false;
  }
  return true;
}

bool beaconHeightFitsSize(const Scene& scene, const BeaconCandidate& c,
                          const BeaconFinderParams& p) {
  return std::fabs(elevationError(scene, c)) <= p.elevationError.rad();
}

bool beaconIsNear(const BeaconCandidate& c, const BeaconFinderParams& p) {
  return c.distance <= p.maxDistance;
}

int weakCues(const Scene& scene, const BeaconCandidate& c) {
  const double elevation = std::fabs(Angle::rad(elevationError(scene, c)).deg());
  const double band = std::max(bandOf(c), 0.5);
  const double wider = c.widest / std::max(c.width, 0.5);
  const double aspect = std::fabs(maths::log(std::max(c.width, 0.5) / band));
  const bool edgeFar = !scene.fieldEdges.empty() && footBelowEdge(scene, c) >= 0.3 * band;
  int weak = c.widthCut ? -1 : 0;  // the border may make it unlike in width
  for (const bool cue :
       {misfit(scene, c) >= 0.5, aspect >= 0.37, elevation >= 0.5, elevation >= 1.0, wider >= 1.75,
        wider >= 4.5, whiteBelow(scene, c).share() < 0.9, edgeFar})
    weak += cue ? 1 : 0;
  return weak;
}

void findBeacons(const Scene& scene, const BeaconFinderParams& params, VisionCounts& counts,
                 Landmarks& landmarks) {
  Found found;
  const auto tried = [&](BeaconCandidate c) {
    measure(scene, params, c);
    if (accepted(scene, c, params, counts))
      found.keep(perceptOf(scene, c, params), misfit(scene, c));
  };
  for (const BeaconFoot& foot : findBeaconFeet(scene)) tried(fromFoot(scene, foot));
  std::size_t candidates = 0;
  for (const Blob& blob : scene.blobs) {
    const auto start = pinkStart(scene, blob, scene.frame.up());
    if (!start || insideBeacon(found.landmarks, *start)) continue;
    if (static_cast<double>(blob.samples) < params.minSamples || candidates == kMaxCandidates) {
      refuse(counts, Refusal::beaconTooSmall);
      continue;
    }
    ++candidates;
    for (const bool pinkIsLower : {true, false}) tried(fromPink(scene, *start, pinkIsLower));
  }
  for (const LandmarkPercept& landmark : found.landmarks) landmarks.push_back(landmark);
}

}  // namespace kelpie::vision
