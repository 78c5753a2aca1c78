// SPDX-License-Identifier: Apache-2.0
#include "vision/beacon/BeaconCandidate.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "vision/ElevationDoubt.h"
#include "vision/pixels/GroundRay.h"
#include "vision/pixels/SpanWalk.h"

namespace kelpie::vision {
namespace {

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
  constexpr std::array<double, 2> kGaps{1.5, 2.5};  // px
  Band band;
  band.edge = walkToEdge(scene.sampler, {from, direction, inside, 1});
  if (band.edge.cut) return band;
  for (const double gap : kGaps) {
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
  constexpr double kWhiteBands = 0.8;     // below the coloured ones
  constexpr double kMinWhiteShare = 0.7;  // of the bands' width; something hides a narrower one
  const ImageDirection up = scene.frame.up();
  const PixelPoint high = moved(c.middle, up, 0.5 * c.upper);
  const PixelPoint low = moved(c.middle, up, -0.5 * c.lower);
  const PixelPoint white = moved(c.bottom, up, -kWhiteBands * c.lower);
  const Width ofUpper = widthAt(scene, high, c.pinkIsLower ? c.partner : ColourClass::pink);
  const Width ofLower = widthAt(scene, low, c.pinkIsLower ? ColourClass::pink : c.partner);
  Width best = better(ofUpper, ofLower);
  if (c.onWhite && Sampler::usable(white) && scene.sampler.classAt(white) == ColourClass::white) {
    const Width foot = widthAt(scene, white, ColourClass::white);
    if (foot.value >= kMinWhiteShare * best.value) best = better(best, foot);
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
// as possible. The border between two colours has no bias.
double measureDistance(const Scene& scene, const BeaconFinderParams& p, const BeaconCandidate& c) {
  constexpr double kMinSlope = 1e-4;  // between the ends
  constexpr double kTooFar = 1e6;     // cm
  const CameraPose& camera = scene.body.camera;
  const double high = groundRayThrough(camera, c.topCut ? c.middle : c.top).slope;
  const double low = groundRayThrough(camera, c.bottomCut ? c.middle : c.bottom).slope;
  const double height = (c.topCut || c.bottomCut ? 1.0 : 2.0) * bandHeight(scene);
  const double ends = (c.topCut ? 0.0 : 0.5) + (c.bottomCut ? 0.0 : 0.5);
  const double slopes = high - low - ends * p.edgeBias / camera.lens.focalLength;
  // The front of the bands is measured, the percept is the axis.
  return slopes > kMinSlope ? height / slopes + scene.field.beaconRadius : kTooFar;
}

}  // namespace

double bandHeight(const Scene& scene) {
  constexpr double kBandShare = 0.25;
  return kBandShare * scene.field.beaconHeight;
}

double bandOf(const BeaconCandidate& c) {
  return c.topCut ? c.lower : c.bottomCut ? c.upper : 0.5 * (c.upper + c.lower);
}

double elevationError(const Scene& scene, const BeaconCandidate& c) {
  const double expected = (kBandsBelowMiddle * bandHeight(scene) - scene.body.camera.position.z) /
                          (c.distance - scene.field.beaconRadius);
  return maths::atan(groundRayThrough(scene.body.camera, c.middle).slope) - maths::atan(expected);
}

double settledElevationError(const Scene& scene, const BeaconCandidate& c) {
  const CameraPose& camera = scene.body.camera;
  return elevationError(scene, c) /
         elevationDoubt(camera, groundRayThrough(camera, c.middle)).spread;
}

BeaconCandidate beaconFromPink(const Scene& scene, PixelPoint pink, bool pinkIsLower) {
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

BeaconCandidate beaconFromFoot(const Scene& scene, const BeaconFoot& foot) {
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
  c.distance = measureDistance(scene, p, c);
}

}  // namespace kelpie::vision
