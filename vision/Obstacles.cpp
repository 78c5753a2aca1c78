// SPDX-License-Identifier: Apache-2.0
#include "vision/Obstacles.h"

#include <algorithm>
#include <cmath>

#include "robot/body/Camera.h"
#include "vision/Refusal.h"
#include "vision/Upright.h"

namespace kelpie::vision {
namespace {

constexpr double kLineStep = 4.0;  // px between scan lines, facts-2005 section 4.1
constexpr int kStep = kLatticeStep;
constexpr int kAbove = 20;  // px upwards that tell a shadow, facts-2005 section 4.2
// Half the diagonal of the image: no line is longer to either side of the middle.
constexpr int kHalfLength = 132;

struct Above {
  int green = 0;  // px
  int orange = 0;
};

Above countAbove(const Scene& scene, ImageUp up, PixelPoint from) {
  Above above;
  for (int way = kStep; way <= kAbove; way += kStep) {
    const PixelPoint at = moved(from, up, 0.0, way);
    if (!Sampler::usable(at)) break;
    const ColourClass c = scene.sampler.classAt(at);
    above.green += c == ColourClass::green ? kStep : 0;
    above.orange += c == ColourClass::orange ? kStep : 0;
  }
  return above;
}

// Whether the pixel lies on the carpet, near enough; counts why not.
bool onCarpet(const Scene& scene, ImageUp up, PixelPoint at, const ObstacleParams& p,
              VisionCounts& counts) {
  const Above above = countAbove(scene, up, at);
  if (above.green > p.maxGreenAbove || above.orange > p.maxBallAbove) {
    refuse(counts, Refusal::obstacleGreenAbove);
    return false;
  }
  if (at.y < fieldEdgeRow(scene, at.x)) {
    refuse(counts, Refusal::obstacleAboveFieldEdge);
    return false;
  }
  return true;
}

// Keeps one pixel: the line's first as a point, every one in the box ahead in the count.
bool keep(const Scene& scene, PixelPoint at, bool first, const ObstacleParams& p,
          Obstacles& found) {
  const auto place = body::groundPoint(scene.body.camera, at);
  if (!place || place->norm() > p.maxDistance) return false;
  if (first) found.points.push_back({*place, at});
  const bool ahead = std::fabs(place->x) <= p.aheadSide && place->y > 0.0 && place->y <= p.aheadFar;
  if (ahead) ++found.ahead;
  return true;
}

// One line from the bottom up: carpet must have been seen before, so that the robot's own chest and
// what lies beyond the carpet do not count.
void scanLine(const Scene& scene, ImageUp up, PixelPoint middle, const ObstacleParams& p,
              VisionCounts& counts, Obstacles& found) {
  int kept = 0;
  int way = -kHalfLength;
  bool carpet = false;
  while (way <= kHalfLength && !Sampler::usable(moved(middle, up, 0.0, way))) way += kStep;
  for (; way <= kHalfLength && kept < p.maxPerLine; way += kStep) {
    const PixelPoint at = moved(middle, up, 0.0, way);
    if (!Sampler::usable(at)) return;
    const int px = Sampler::pixelOf(at.x);
    const int py = Sampler::pixelOf(at.y);
    const ColourClass c = scene.sampler.classAt(px, py);
    carpet = carpet || c == ColourClass::green;
    if (c == ColourClass::green || !carpet) continue;
    if (!isObstacleColour(scene.sampler, px, py, p)) continue;
    if (!onCarpet(scene, up, at, p, counts)) continue;
    if (!keep(scene, at, kept == 0, p, found)) return;
    ++kept;
  }
}

}  // namespace

bool isObstacleColour(const Sampler& sampler, int px, int py, const ObstacleParams& p) {
  switch (sampler.classAt(px, py)) {
    case ColourClass::green:
    case ColourClass::white:
    case ColourClass::orange:
    case ColourClass::yellow:
    case ColourClass::pink: return false;
    case ColourClass::grey: return p.greyCounts || sampler.corrected(px, py).y < p.maxBrightness;
    default: return sampler.corrected(px, py).y < p.maxBrightness;
  }
}

Obstacles findObstacles(const Scene& scene, const ObstacleParams& params, VisionCounts& counts) {
  const ImageUp up = imageUp(scene.body.camera);
  const PixelPoint middle{0.5 * kImageWidth, 0.5 * kImageHeight};
  Obstacles found;
  for (double aside = -kHalfLength; aside <= kHalfLength; aside += kLineStep) {
    scanLine(scene, up, moved(middle, up, aside, 0.0), params, counts, found);
  }
  return found;
}

}  // namespace kelpie::vision
