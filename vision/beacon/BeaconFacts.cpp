// SPDX-License-Identifier: Apache-2.0
#include "vision/beacon/BeaconFacts.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "vision/LogOdds.h"

namespace kelpie::vision {
namespace {

constexpr double kFarFoot = 4.0;       // bands
constexpr double kFirstWhite = 0.2;    // bands below the coloured ones, past the mixed pixels
constexpr double kWhiteBands = 1.9;    // below the coloured ones, less the blur of the last
constexpr double kFootBands = 3.2;     // below the coloured ones the carpet has begun
constexpr double kFootPixels = 5.0;    // and so many pixels more
constexpr double kProbeStep = 0.5;     // px
constexpr double kBlurBeside = 2.0;    // px beside a band whose colours may be mixed
constexpr double kBesideShare = 0.25;  // of a band's width, how far beside it its colour is sought
constexpr double kFirstStrange = 0.7;  // bands below the coloured ones, where the count begins
constexpr double kMinLength = 0.5;     // px, so that a ratio stays finite
constexpr double kUnknownWhite = 0.5;  // share, where none of it is in the image

double logRatio(double a, double b) {
  return logOfRatio(std::max(a, kMinLength) / std::max(b, kMinLength));
}

struct Tally {
  int all = 0;
  int hits = 0;
  void count(bool hit) {
    ++all;
    hits += hit ? 1 : 0;
  }
  double share(double ofNone) const { return all > 0 ? static_cast<double>(hits) / all : ofNone; }
};

// The two bands below the coloured part, as far as the image shows them.
Tally whiteBelow(const Scene& scene, const BeaconCandidate& c) {
  const double band = bandOf(c);
  Tally tally;
  for (double down = kFirstWhite * band; down < kWhiteBands * band; down += kProbeStep) {
    const PixelPoint at = moved(c.bottom, scene.frame.up(), -down);
    if (!Sampler::usable(at)) break;
    const ColourClass colour = scene.sampler.classAt(at);
    tally.count(colour == ColourClass::white || colour == ColourClass::grey);
  }
  return tally;
}

// Of what is probed.
double whiteShows(const Tally& white, const BeaconCandidate& c) {
  const double whole = (kWhiteBands - kFirstWhite) * bandOf(c);
  return std::min(1.0, kProbeStep * white.all / std::max(whole, kProbeStep));
}

// Its foot is three bands below the border between the colours.
double footBelowEdge(const Scene& scene, const BeaconCandidate& c) {
  if (scene.fieldEdges.empty()) return 0.0;
  const double band = std::max(bandOf(c), 1.0);
  const double below =
      belowFieldEdge(scene, moved(c.middle, scene.frame.up(), -kBandsBelowMiddle * bandOf(c)));
  return maths::clamp(below / band, -kFarFoot, kFarFoot);
}

bool mayHideFoot(ColourClass colour) {
  return colour != ColourClass::none && colour != ColourClass::blue &&
         colour != ColourClass::yellow && colour != ColourClass::pink;
}

// Where its 20 cm of white end the carpet begins, or a robot or a ball hides it.
double strangeBelow(const Scene& scene, const BeaconCandidate& c) {
  if (c.bottomCut) return 0.0;
  const double band = std::max(bandOf(c), 1.0);
  int strange = 0;
  int longest = 0;
  for (double down = kFirstStrange * band; down < kFootBands * band + kFootPixels; down += 1.0) {
    const PixelPoint at = moved(c.bottom, scene.frame.up(), -down);
    if (!Sampler::usable(at)) break;
    const ColourClass colour = scene.sampler.classAt(at);
    if (colour == ColourClass::green) break;
    strange = mayHideFoot(colour) ? 0 : strange + 1;
    longest = std::max(longest, strange);
  }
  return longest / band;
}

// Points of a band from its end towards the border between the colours.
struct BandPoints {
  PixelPoint middle;  // of the bands' border
  ImageDirection towardsEnd;
  double height = 0.0;
  double width = 0.0;
  ColourClass colour = ColourClass::none;
};

PixelPoint pointOf(const Scene& scene, const BandPoints& band, double along, double across) {
  const PixelPoint on = moved(band.middle, band.towardsEnd, along * band.height);
  return moved(on, scene.frame.right(), across);
}

void countFilled(const Scene& scene, const BandPoints& band, Tally& tally) {
  constexpr std::array<double, 4> kAlong{0.2, 0.4, 0.6, 0.8};              // of the height
  constexpr std::array<double, 5> kAcross{-0.36, -0.18, 0.0, 0.18, 0.36};  // of the width
  for (const double along : kAlong) {
    for (const double across : kAcross) {
      const PixelPoint at = pointOf(scene, band, along, across * band.width);
      if (Sampler::usable(at)) tally.count(scene.sampler.classAt(at) == band.colour);
    }
  }
}

void countBeside(const Scene& scene, const BandPoints& band, Tally& tally) {
  constexpr std::array<double, 3> kAlong{0.25, 0.5, 0.75};  // of the height
  const double lateral = 0.5 * band.width + std::max(kBlurBeside, kBesideShare * band.width);
  for (const double along : kAlong) {
    for (const double across : {-lateral, lateral}) {
      const PixelPoint at = pointOf(scene, band, along, across);
      if (Sampler::usable(at)) tally.count(scene.sampler.classAt(at) == band.colour);
    }
  }
}

void fillPointFacts(const Scene& scene, const BeaconCandidate& c, BeaconFacts& facts) {
  const ImageDirection up = scene.frame.up();
  const ColourClass pink = ColourClass::pink;
  const BandPoints upper{c.middle, up, c.upper, c.width, c.pinkIsLower ? c.partner : pink};
  const BandPoints lower{c.middle, -up, c.lower, c.width, c.pinkIsLower ? pink : c.partner};
  Tally filled;
  Tally beside;
  for (const BandPoints& band : {upper, lower}) {
    countFilled(scene, band, filled);
    countBeside(scene, band, beside);
  }
  facts.filled = filled.share(0.0);
  facts.beside = beside.share(0.0);
}

}  // namespace

BeaconFacts beaconFacts(const Scene& scene, const BeaconCandidate& c) {
  BeaconFacts facts;
  const Tally white = whiteBelow(scene, c);
  facts.distance = c.distance;
  facts.band = bandOf(c);
  if (!c.topCut && !c.bottomCut) facts.bandRatio = std::fabs(logRatio(c.upper, c.lower));
  facts.aspect = logRatio(c.width, bandOf(c));
  facts.wider = logRatio(c.widest, c.width);
  const double error = settledElevationError(scene, c);
  facts.elevationError = std::fabs(Angle::rad(error).deg());
  facts.belowHorizon =
      belowHorizon(scene, c.middle) + focalLength(scene) * (elevationError(scene, c) - error);
  facts.whiteShare = white.share(kUnknownWhite);
  facts.whiteShows = whiteShows(white, c);
  facts.edgeShows = flag(!scene.fieldEdges.empty());
  facts.footBelowEdge = footBelowEdge(scene, c);
  facts.strangeBelow = strangeBelow(scene, c);
  facts.onWhite = flag(c.onWhite);
  facts.topCut = flag(c.topCut);
  facts.bottomCut = flag(c.bottomCut);
  // The border explains a band that is too narrow; what shows of it is never too wide.
  constexpr double kTooWide = 0.3;
  facts.widthCut = flag(c.widthCut && facts.aspect <= kTooWide);
  fillPointFacts(scene, c, facts);
  return facts;
}

}  // namespace kelpie::vision
