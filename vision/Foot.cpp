// SPDX-License-Identifier: Apache-2.0
#include "vision/Foot.h"

#include <algorithm>

#include "vision/Sight.h"

namespace kelpie::vision {
namespace {

constexpr int kStep = 2;    // px; the lattice's, whose classes are known
constexpr int kGreens = 2;  // in a row that make carpet: a gap between toes is narrower
constexpr int kMixed = 1;   // samples between green and white that are neither
constexpr int kOthers = 2;  // in a row that are another thing

// Pixels of carpet behind a foot: looked for so far, enough when the image ends there, most that is
// believed of one side alone, where another thing may stand.
constexpr double kFarthest = 16.0;
constexpr double kEnough = 6.0;
constexpr double kMostOneSided = 3.0;
constexpr double kFarShare = 1.6;  // of the second place beside a foot over the first
constexpr int kWidestLine = 4;     // px of white that the carpet goes on behind

// Other things than the one with the colour `own`. A dark blue uniform looks like a blue goal here
// and there.
bool isOther(ColourClass c, ColourClass own) {
  if (c == own) return false;
  return c == ColourClass::orange || c == ColourClass::yellow || c == ColourClass::pink ||
         (c == ColourClass::blue && own != ColourClass::robotBlue);
}

// The border between the last pixel of the thing and the first of the carpet.
PixelPoint refined(const Scene& scene, PixelPoint from, ImageUp up, int firstGreen) {
  const PixelPoint before = moved(from, up, 0.0, 1.0 - firstGreen);
  const bool alsoGreen =
      Sampler::usable(before) && scene.sampler.classAt(before) == ColourClass::green;
  return moved(from, up, 0.0, (alsoGreen ? 1.5 : 0.5) - firstGreen);
}

// How far the carpet goes on above a level line through the foot, at one place beside it: negative
// where it ends below, nothing where the image ends first. A white line does not end it.
std::optional<double> carpetAbove(const Scene& scene, ImageUp up, PixelPoint foot, double aside) {
  int gap = 0;
  double last = -kFarthest;
  for (double above = last; above <= kFarthest && gap <= kWidestLine; above += 1.0) {
    const PixelPoint at = moved(foot, up, aside, above);
    if (!Sampler::usable(at)) {
      return last >= kEnough ? std::optional<double>(last) : std::nullopt;
    }
    const bool green = scene.sampler.classAt(at) == ColourClass::green;
    gap = green ? 0 : gap + 1;
    if (green) last = above;
  }
  return last;
}

}  // namespace

// The middle of two places, or the straight line through two places on one side when the other side
// is not in the image.
double carpetBehind(const Scene& scene, ImageUp up, PixelPoint foot, double beside) {
  const double farther = kFarShare * beside;
  const auto right = carpetAbove(scene, up, foot, beside);
  const auto left = carpetAbove(scene, up, foot, -beside);
  const auto farRight = carpetAbove(scene, up, foot, farther);
  const auto farLeft = carpetAbove(scene, up, foot, -farther);
  double best = kUnknownBehind;
  if (left && right) best = std::max(best, 0.5 * (*left + *right));
  if (farLeft && farRight) best = std::max(best, 0.5 * (*farLeft + *farRight));
  if (best > kUnknownBehind) return best;
  const double lean = 1.0 / (kFarShare - 1.0);
  if (right && farRight) best = std::max(best, *right - lean * (*farRight - *right));
  if (left && farLeft) best = std::max(best, *left - lean * (*farLeft - *left));
  return std::min(best, kMostOneSided);
}

std::optional<double> groundDistance(const CameraPose& camera, PixelPoint pixel) {
  const double slope = sightOf(camera, pixel).slope;
  if (slope > -1e-3) return std::nullopt;
  return -camera.position.z / slope;
}

double heightAt(const CameraPose& camera, PixelPoint pixel, double distance) {
  return camera.position.z + distance * sightOf(camera, pixel).slope;
}

Foot footBelow(const Scene& scene, PixelPoint from, ImageUp up, ColourClass own) {
  Foot foot;
  int greens = 0;
  int first = 0;
  int gap = 0;
  int others = 0;
  for (int way = 0;; way += kStep) {
    const PixelPoint at = moved(from, up, 0.0, -way);
    if (!Sampler::usable(at)) {
      foot.pixel = at;
      if (const auto ground = groundDistance(scene.body.camera, at)) {
        foot.end = FootEnd::imageBorder;
        foot.distance = *ground;
      }
      return foot;
    }
    const ColourClass seen = scene.sampler.classAt(at);
    // White does not end carpet that began: a line runs 20 cm before its end.
    const bool green = seen == ColourClass::green;
    gap = green ? 0 : gap + (seen == ColourClass::white ? 0 : 1);
    greens = gap > kMixed ? 0 : greens + (green ? 1 : 0);
    if (green && greens == 1) first = way;
    others = isOther(seen, own) ? others + 1 : 0;
    if (others >= kOthers) return foot;
    if (!green || greens < kGreens) continue;
    foot.pixel = refined(scene, from, up, first);
    const auto distance = groundDistance(scene.body.camera, foot.pixel);
    if (!distance) return foot;
    foot.end = FootEnd::carpet;
    foot.distance = *distance;
    return foot;
  }
}

}  // namespace kelpie::vision
