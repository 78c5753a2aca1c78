// SPDX-License-Identifier: Apache-2.0
#include "vision/goal/GoalColour.h"

#include "robot/core/Maths.h"

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
  constexpr Chroma paint = kBlueOverCarpet;
  const Yuv here = scene.sampler.corrected(Sampler::pixelOf(p.x), Sampler::pixelOf(p.y));
  const double along = (here.cr - carpet.cr) * paint.cr + (here.cb - carpet.cb) * paint.cb;
  return along / (maths::square(paint.cr) + maths::square(paint.cb));
}

}  // namespace kelpie::vision
