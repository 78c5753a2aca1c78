// SPDX-License-Identifier: Apache-2.0
#include "vision/Foot.h"

#include "vision/Sight.h"

namespace kelpie::vision {
namespace {

constexpr int kStep = 2;    // px; the lattice's, whose classes are known
constexpr int kGreens = 2;  // in a row that make carpet: a gap between toes is narrower
constexpr int kMixed = 1;   // samples between green and white that are neither
constexpr int kOthers = 2;  // in a row that are another thing

// Other things than the one with the colour `own`. A dark blue uniform looks like a blue goal here
// and there.
bool isOther(ColourClass c, ColourClass own) {
  if (c == own) return false;
  return c == ColourClass::orange || c == ColourClass::yellow || c == ColourClass::pink ||
         (c == ColourClass::blue && own != ColourClass::robotBlue);
}

PixelPoint below(PixelPoint from, ImageUp up, double way) {
  return {from.x - way * up.dx, from.y - way * up.dy};
}

// The border between the last pixel of the thing and the first of the carpet.
PixelPoint refined(const Scene& scene, PixelPoint from, ImageUp up, int firstGreen) {
  const PixelPoint before = below(from, up, firstGreen - 1.0);
  const bool alsoGreen =
      Sampler::usable(before) && scene.sampler.classAt(before) == ColourClass::green;
  return below(from, up, firstGreen - (alsoGreen ? 1.5 : 0.5));
}

}  // namespace

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
    const PixelPoint at = below(from, up, way);
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
