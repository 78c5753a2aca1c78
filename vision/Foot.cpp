// SPDX-License-Identifier: Apache-2.0
#include "vision/Foot.h"

#include <algorithm>

#include "vision/pixels/GroundRay.h"
#include "vision/pixels/PixelWalk.h"

namespace kelpie::vision {
namespace {

constexpr int kStep = 2;       // px; the lattice's, whose classes are known
constexpr int kMinGreens = 2;  // in a row that make carpet: a gap between toes is narrower
constexpr int kMaxMixed = 1;   // samples between green and white that are neither
constexpr int kMinOthers = 2;  // in a row that are another thing

// Pixels of carpet behind a foot.
constexpr int kMaxSearched = 16;
constexpr int kMinAtBorder = 6;       // seen when the image ends there
constexpr double kMaxOneSided = 3.0;  // of one side alone, where another thing may stand
constexpr double kFarShare = 1.6;     // of the second place beside a foot over the first
constexpr int kMaxLineWidth = 4;      // px of white that the carpet goes on behind

// The colour of another thing than the one whose colour is `own`. A dark blue uniform looks like a
// blue goal here and there.
// As bits by class: a column's sample is asked in two instructions.
unsigned othersThan(ColourClass own) {
  const auto bit = [](ColourClass c) { return 1U << index(c); };
  unsigned others = bit(ColourClass::orange) | bit(ColourClass::yellow) | bit(ColourClass::pink);
  if (own != ColourClass::robotBlue) others |= bit(ColourClass::blue);
  return others & ~bit(own);
}

// What a column's pixels, read downwards, say of the carpet's beginning.
struct ColumnReader {
  unsigned foreign;  // classes of other things
  int greens = 0;
  int first = 0;  // way to the first green
  int gap = 0;
  int others = 0;

  // White does not end carpet that began: a line runs 20 cm before its end.
  void read(ColourClass seen, int way) {
    others = ((foreign >> index(seen)) & 1U) != 0 ? others + 1 : 0;
    if (seen == ColourClass::green) {
      gap = 0;
      if (greens++ == 0) first = way;
    } else if (seen != ColourClass::white && ++gap > kMaxMixed) {
      greens = 0;
    }
  }
};

// One column on the lattice, to 2 px: pixel and end, no distance yet.
Foot coarseFoot(const Scene& scene, PixelPoint from, unsigned foreign) {
  ColumnReader reader{foreign};
  const PixelWalk down(from, -scene.frame.up());
  for (int way = 0; reader.others < kMinOthers; way += kStep) {
    const int px = down.x(way);
    const int py = down.y(way);
    if (!inCoarse(px, py)) return {FootEnd::imageBorder, scene.frame.beside(from, 0.0, -way)};
    reader.read(coarseClass(scene.sampler, px, py), way);
    if (reader.greens >= kMinGreens)
      return {FootEnd::carpet, scene.frame.beside(from, 0.0, -reader.first)};
  }
  return {};
}

// From the coarse place of the first green to the border before it, pixel by pixel.
PixelPoint refined(const Scene& scene, PixelPoint coarse) {
  for (int above = kStep + 1; above >= -1; --above) {
    const PixelPoint at = scene.frame.beside(coarse, 0.0, above);
    if (Sampler::usable(at) && scene.sampler.classAt(at) == ColourClass::green)
      return scene.frame.beside(coarse, 0.0, above + 0.5);
  }
  return coarse;
}

// Whether a coarse foot is no nearer than what is wanted wherever `refined` would place it.
bool isFarther(const Scene& scene, const Foot& coarse, double nearer) {
  const PixelPoint lowest = scene.frame.beside(coarse.pixel, 0.0, -0.5);
  return groundDistance(scene.body.camera, lowest).value_or(kNoDistance) >= nearer;
}

// How far the carpet goes on above a level line through the foot, at one place beside it: negative
// where it ends below, nothing where the image ends first. A white line does not end it.
std::optional<double> carpetAbove(const Scene& scene, PixelPoint foot, double lateral) {
  const PixelWalk up(scene.frame.beside(foot, lateral, 0.0), scene.frame.up());
  int gap = 0;
  int last = -kMaxSearched;
  for (int above = last; above <= kMaxSearched && gap <= kMaxLineWidth; ++above) {
    const int px = up.x(above);
    const int py = up.y(above);
    if (!Sampler::usable(px, py)) {
      return last >= kMinAtBorder ? std::optional<double>(last) : std::nullopt;
    }
    const bool green = scene.sampler.classAt(px, py) == ColourClass::green;
    gap = green ? 0 : gap + 1;
    if (green) last = above;
  }
  return last;
}

}  // namespace

// The middle of two places, or the straight line through two places on one side when the other side
// is not in the image.
double carpetBehind(const Scene& scene, PixelPoint foot, double beside) {
  const double farther = kFarShare * beside;
  const auto right = carpetAbove(scene, foot, beside);
  const auto left = carpetAbove(scene, foot, -beside);
  const auto farRight = carpetAbove(scene, foot, farther);
  const auto farLeft = carpetAbove(scene, foot, -farther);
  double best = kUnknownBehind;
  if (left && right) best = std::max(best, 0.5 * (*left + *right));
  if (farLeft && farRight) best = std::max(best, 0.5 * (*farLeft + *farRight));
  if (best > kUnknownBehind) return best;
  const double lean = 1.0 / (kFarShare - 1.0);
  if (right && farRight) best = std::max(best, *right - lean * (*farRight - *right));
  if (left && farLeft) best = std::max(best, *left - lean * (*farLeft - *left));
  return std::min(best, kMaxOneSided);
}

std::optional<double> groundDistance(const CameraPose& camera, PixelPoint pixel) {
  constexpr double kMinDescent = 1e-3;  // of the ray; a flatter one meets no ground of the field
  const double slope = groundRayThrough(camera, pixel).slope;
  if (slope > -kMinDescent) return std::nullopt;
  return -camera.position.z / slope;
}

double heightAt(const CameraPose& camera, PixelPoint pixel, double distance) {
  return camera.position.z + distance * groundRayThrough(camera, pixel).slope;
}

Foot nearestFoot(const Scene& scene, const FootSearch& search) {
  Foot best;
  const unsigned foreign = othersThan(search.own);
  for (int i = 0; i < search.columns; ++i) {
    const double share = search.columns > 1 ? i / (search.columns - 1.0) : 0.5;
    const double lateral = search.first + (search.last - search.first) * share;
    const PixelPoint from = scene.frame.beside(search.from, lateral, 0.0);
    if (!Sampler::usable(from)) continue;
    Foot foot = coarseFoot(scene, from, foreign);
    if (foot.end == FootEnd::hidden) continue;
    const auto distance = groundDistance(scene.body.camera, foot.pixel);
    if (!distance || *distance >= best.distance) continue;
    best = foot;
    best.distance = *distance;
  }
  if (best.end != FootEnd::carpet || isFarther(scene, best, search.nearer)) return best;
  best.pixel = refined(scene, best.pixel);
  best.distance = groundDistance(scene.body.camera, best.pixel).value_or(kNoDistance);
  return best;
}

}  // namespace kelpie::vision
