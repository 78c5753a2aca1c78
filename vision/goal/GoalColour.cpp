// SPDX-License-Identifier: Apache-2.0
#include "vision/goal/GoalColour.h"

#include <array>

#include "robot/core/Maths.h"
#include "vision/pixels/Between.h"

namespace kelpie::vision {
namespace {

constexpr int kGrid = 16;      // px; 130 places
constexpr int kMinGreens = 6;  // of the grid

// Of goal less carpet, from the centres of the trained 2005 table (facts-2005 section 3).
struct Chroma {
  double cr;
  double cb;
};
constexpr Chroma kBlueOverCarpet{18, 70};

// The median of 113 labelled pixels of goals and beacons (data/colour). A table that calls these
// blue takes paler blues than the nominal one, and no paint tells its goals from a floor.
constexpr Yuv kGenuineBlue{33, 118, 129};

}  // namespace

CarpetColour carpetColour(const Scene& scene) {
  if (scene.sampler.classOf(kGenuineBlue) == ColourClass::blue) return {};
  double cr = 0.0;
  double cb = 0.0;
  int greens = 0;
  for (int y = kCoarseTop; y < kUsableBottom; y += kGrid)
    for (int x = kCoarseLeft; x < kUsableRight; x += kGrid) {
      if (scene.sampler.classAt(x, y) != ColourClass::green) continue;
      const Yuv here = scene.sampler.corrected(x, y);
      cr += here.cr;
      cb += here.cb;
      ++greens;
    }
  if (greens < kMinGreens) return {};
  return {true, cr / greens, cb / greens};
}

double paintShare(const Scene& scene, const CarpetColour& carpet, ColourClass colour,
                  PixelPoint p) {
  if (!carpet.known || colour != ColourClass::blue) return 1.0;
  constexpr Chroma kPaint = kBlueOverCarpet;
  constexpr double kPerSquare = 1.0 / (kPaint.cr * kPaint.cr + kPaint.cb * kPaint.cb);
  const Yuv here = scene.sampler.corrected(Sampler::pixelOf(p.x), Sampler::pixelOf(p.y));
  const double along = (here.cr - carpet.cr) * kPaint.cr + (here.cb - carpet.cb) * kPaint.cb;
  return along * kPerSquare;
}

std::optional<double> paintedShare(const Scene& scene, const CarpetColour& carpet,
                                   ColourClass colour, PixelPoint foot, PixelPoint top) {
  constexpr double kPale = 0.85;  // of the paint at the foot
  constexpr int kHalvings = 5;
  // Shares of the way from foot to top: the two lower ones show the paint, the two upper ones
  // whether anything paler follows; where it begins is sought between the inner two.
  constexpr double kLowest = 0.15;
  constexpr double kSearchFrom = 0.3;
  constexpr double kSearchTo = 0.8;
  constexpr double kHighest = 0.92;
  if (!carpet.known || colour != ColourClass::blue) return std::nullopt;
  constexpr std::array<double, 3> kNeighbours{-1.0, 0.0, 1.0};  // px, against noise
  const auto paint = [&](double share) {
    const PixelPoint p = between(foot, top, share);
    double sum = 0.0;
    for (const double lateral : kNeighbours)
      sum += paintShare(scene, carpet, colour, moved(p, scene.frame.right(), lateral));
    return sum / static_cast<double>(kNeighbours.size());
  };
  const double pale = kPale * 0.5 * (paint(kLowest) + paint(kSearchFrom));
  double in = kSearchFrom;
  double out = kSearchTo;
  if (0.5 * (paint(out) + paint(kHighest)) >= pale) return std::nullopt;
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = 0.5 * (in + out);
    (paint(middle) >= pale ? in : out) = middle;
  }
  return in;
}

}  // namespace kelpie::vision
