// SPDX-License-Identifier: Apache-2.0
#include "vision/robot/Obstacles.h"

#include <algorithm>
#include <cmath>

#include "robot/body/Camera.h"
#include "vision/Refusal.h"
#include "vision/pixels/ClippedRange.h"

namespace kelpie::vision {
namespace {

// Every 8 px: 2005 scanned every 16 px in full and every 4 px near the horizon (facts-2005 section
// 4.1), 26 lines of ours cost 30 k instructions.
constexpr double kLineStep = 8.0;
constexpr int kStep = kLatticeStep;
constexpr int kShadowReach = 20;  // px upwards that tell a shadow, facts-2005 section 4.2
// Half the diagonal of the image: no line is longer to either side of the middle.
constexpr int kHalfLength = 132;

struct Above {
  int green = 0;  // px
  int orange = 0;
};

Above countAbove(const Scene& scene, PixelPoint from) {
  Above above;
  for (int way = kStep; way <= kShadowReach; way += kStep) {
    const PixelPoint at = moved(from, scene.frame.up(), way);
    const int px = static_cast<int>(at.x);
    const int py = static_cast<int>(at.y);
    if (!inCoarse(px, py)) break;
    const ColourClass c = coarseClass(scene.sampler, px, py);
    above.green += c == ColourClass::green ? kStep : 0;
    above.orange += c == ColourClass::orange ? kStep : 0;
  }
  return above;
}

// Whether the pixel lies on the carpet, near enough; counts why not.
bool onCarpet(const Scene& scene, PixelPoint at, const ObstacleParams& p, VisionCounts& counts) {
  const Above above = countAbove(scene, at);
  if (above.green > p.maxGreenAbove || above.orange > p.maxBallAbove) {
    refuse(counts, Refusal::obstacleGreenAbove);
    return false;
  }
  if (belowFieldEdge(scene, at) < 0.0) {
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

// The ways along a line, from its middle point, between which it is in the image and sees the
// ground nearer than the farthest obstacle.
ClippedRange inView(const Scene& scene, PixelPoint middle, const ObstacleParams& p) {
  constexpr double kInside = 1e-6;  // px; the borders on the right and below are not in the image
  const ImageDirection up = scene.frame.up();
  ClippedRange range{-kHalfLength, kHalfLength};
  range.clip(middle.x, up.dx, kCoarseLeft, kUsableRight - kInside);
  range.clip(middle.y, up.dy, kCoarseTop, kUsableBottom - kInside);
  // The ray's height per focal length grows along the line; at the farthest obstacle's distance it
  // is -height / distance or a little more.
  const CameraPose& camera = scene.body.camera;
  const auto& a = camera.axes;
  const double rise = a[6] * up.dx + a[7] * up.dy;
  const double start = a[6] * (middle.x - camera.lens.principalX) +
                       a[7] * (middle.y - camera.lens.principalY) + a[8] * focalLength(scene);
  const double highest = -camera.position.z / p.maxDistance * focalLength(scene);
  if (rise > 1e-9) range.to = std::min(range.to, (highest - start) / rise);
  return range;
}

// One line from the bottom up: carpet must have been seen before, so that the robot's own chest
// does not count.
void walkUp(const Scene& scene, PixelPoint middle, const ObstacleParams& p, VisionCounts& counts,
            Obstacles& found) {
  const ClippedRange range = inView(scene, middle, p);
  int kept = 0;
  bool carpet = false;
  for (double way = range.from; way <= range.to && kept < p.maxPerLine; way += kStep) {
    const PixelPoint at = moved(middle, scene.frame.up(), way);
    const int px = static_cast<int>(at.x) & ~1;
    const int py = static_cast<int>(at.y) & ~1;
    const ColourClass c = scene.sampler.classAt(px, py);
    carpet = carpet || c == ColourClass::green;
    if (c == ColourClass::green || !carpet) continue;
    if (!isObstacleColour(scene.sampler, px, py, p)) continue;
    if (!onCarpet(scene, at, p, counts)) continue;
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
  const PixelPoint middle{0.5 * kImageWidth, 0.5 * kImageHeight};
  Obstacles found;
  for (double aside = -kHalfLength; aside <= kHalfLength; aside += kLineStep) {
    walkUp(scene, scene.frame.beside(middle, aside, 0.0), params, counts, found);
  }
  return found;
}

}  // namespace kelpie::vision
