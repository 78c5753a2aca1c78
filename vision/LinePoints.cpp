// SPDX-License-Identifier: Apache-2.0
#include "vision/LinePoints.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "robot/body/Camera.h"
#include "robot/core/Maths.h"

namespace kelpie::vision {
namespace {

constexpr int kLatticeLeft = 4;
constexpr int kLatticeTop = 4;
constexpr int kLatticeStep = 2;

constexpr int kColumnStep = 8;
constexpr int kReach = 2;  // px over which a blurred edge rises

int stepAt(const Sampler& sampler, int px, int py) {
  return sampler.rawY(px, py) - sampler.rawY(px, py + kReach);
}

// Green just outside both edges of the bright stretch [top, bottom].
bool betweenGreen(const Sampler& sampler, int px, int top, int bottom) {
  const int above = top - kReach;
  const int below = bottom + kReach;
  return Sampler::usable(px, above) && Sampler::usable(px, below) &&
         sampler.classAt(px, above) == ColourClass::green &&
         sampler.classAt(px, below) == ColourClass::green;
}

// White on green changes the chroma little; a ball or a sock changes it much.
bool colourless(const Sampler& sampler, int px, int inside, int outside, double maxChroma) {
  const Yuv a = sampler.corrected(px, inside);
  const Yuv b = sampler.corrected(px, outside);
  return std::abs(a.cr - b.cr) <= maxChroma && std::abs(a.cb - b.cb) <= maxChroma;
}

struct Stretch {
  int top = 0;
  int bottom = 0;
};
using Column = FixedVector<Stretch, 32>;

// Bright stretches of a column, found from below: brighter upwards, then darker upwards.
Column brightStretches(const Sampler& sampler, int px, int highest, const LineParams& params) {
  Column found;
  const int minStep = static_cast<int>(params.minStep);
  int bottom = -1;
  for (int py = kUsableBottom - kReach - 1; py >= highest; --py) {
    const int step = stepAt(sampler, px, py);
    if (step >= minStep) {
      bottom = py + 1;
    } else if (step <= -minStep && bottom >= 0) {
      if (bottom - py <= params.maxWidth) found.push_back({py + 1, bottom});
      bottom = -1;
    }
  }
  return found;
}

void addPoint(const Scene& scene, int px, Stretch s, const LineParams& params,
              LinePointBuffer& points) {
  if (!betweenGreen(scene.sampler, px, s.top, s.bottom)) return;
  const int middle = (s.top + s.bottom) / 2;
  if (!colourless(scene.sampler, px, middle, s.bottom + kReach, params.maxChroma)) return;
  const PixelPoint pixel{px + 0.5, 0.5 * (s.top + s.bottom) + 0.5};
  const auto place = body::groundPoint(scene.body.camera, pixel);
  if (!place) return;
  const double weight = lineWeight(place->norm(), params);
  if (weight > 0.0) points.push_back({LinePointKind::line, *place, weight, pixel});
}

}  // namespace

double lineWeight(double distance, const LineParams& params) {
  const double near = maths::square(params.fullWeight);
  const double far = maths::square(params.noWeight);
  return maths::clamp((far - distance * distance) / (far - near), 0.0, 1.0);
}

void findLinePoints(const Scene& scene, const LineParams& params, LinePointBuffer& points) {
  if (scene.body.headSpeed >= params.maxHeadSpeed.rad()) return;
  for (int px = kLatticeLeft; px < kUsableRight; px += kColumnStep) {
    const double limit = std::max(horizonRow(scene, px), fieldEdgeRow(scene, px));
    const int highest = static_cast<int>(maths::clamp(limit, kUsableTop + kReach * 1.0, 1e3));
    const Column column = brightStretches(scene.sampler, px, highest, params);
    if (static_cast<double>(column.size()) > params.maxPerColumn) continue;
    for (const Stretch& s : column) addPoint(scene, px, s, params, points);
  }
}

}  // namespace kelpie::vision
