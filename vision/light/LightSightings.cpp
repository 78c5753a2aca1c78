// SPDX-License-Identifier: Apache-2.0
#include "vision/light/LightSightings.h"

#include <algorithm>
#include <cmath>

#include "robot/core/Maths.h"

namespace kelpie::vision {
namespace {

constexpr double kNeutral = 128.0;

struct Chroma {
  double cr = 0.0;
  double cb = 0.0;
  double norm() const { return std::sqrt(cr * cr + cb * cb); }
};

Chroma chromaOf(const SurfaceColour& c) { return {c.cr - kNeutral, c.cb - kNeutral}; }
Chroma chromaOf(Yuv c) { return {c.cr - kNeutral, c.cb - kNeutral}; }
double dot(const Chroma& a, const Chroma& b) { return a.cr * b.cr + a.cb * b.cb; }

// Of pixels of one kind: their brightness, their colour in the expected direction, and both as
// expected.
struct Sums {
  int count = 0;
  double y = 0.0;
  double expectedY = 0.0;
  double chroma = 0.0;
  double expectedChroma = 0.0;

  void add(Yuv pixel, const SurfaceColour& expected) {
    const Chroma direction = chromaOf(expected);
    const double norm = direction.norm();
    ++count;
    y += pixel.y;
    expectedY += expected.y;
    chroma += dot(chromaOf(pixel), direction) / norm;
    expectedChroma += norm;
  }
  LightSighting ratio(int least) const {
    if (count < least || y <= 0.0 || chroma <= 0.0) return {};
    return {true, maths::log(y / expectedY), maths::log(chroma / expectedChroma)};
  }
};

// Of the carpet's chroma in the darkest light there are some 8 levels left.
bool isCarpets(const Chroma& chroma, const Chroma& expected) {
  constexpr double kMinChroma = 5.0;  // levels
  constexpr double kCosine = 0.85;    // of 32 deg
  const double norm = chroma.norm();
  return norm > kMinChroma && dot(chroma, expected) > kCosine * norm * expected.norm();
}

LightSighting seenCarpet(const Scene& scene, const LightParams& params) {
  constexpr int kColumnStep = 13;  // px; 15 columns
  constexpr int kRows = 6;         // of each column
  constexpr double kBelow = 8.0;   // px below the horizon and the field edge
  constexpr int kMin = 15;         // pixels of the carpet
  const Chroma expected = chromaOf(params.carpet);
  Sums sums;
  for (int px = kCoarseLeft + 2; px < kUsableRight; px += kColumnStep) {
    const double above = std::max(horizonRow(scene, px), fieldEdgeRow(scene, px)) + kBelow;
    const double top = std::max(above, kUsableTop * 1.0);
    const double step = (kUsableBottom - top) / kRows;
    if (step < 1.0) continue;
    for (int row = 0; row < kRows; ++row) {
      const Yuv pixel = scene.sampler.corrected(px, static_cast<int>(top + row * step));
      if (isCarpets(chromaOf(pixel), expected)) sums.add(pixel, params.carpet);
    }
  }
  return sums.ratio(kMin);
}

// The brightest pixel across a line: near ones are wide enough to have one without carpet.
std::uint8_t brightestNear(const Sampler& sampler, int px, int py) {
  std::uint8_t most = 0;
  for (int dy = -1; dy <= 1; ++dy)
    if (Sampler::usable(px, py + dy)) most = std::max(most, sampler.corrected(px, py + dy).y);
  return most;
}

LightSighting seenLines(const Scene& scene, const Percepts& percepts, const LightParams& params) {
  constexpr double kFarthest = 90.0;  // cm
  constexpr int kMin = 2;             // points
  int count = 0;
  double sum = 0.0;
  for (const LinePoint& point : percepts.linePoints) {
    if (point.kind != LinePointKind::line || distance(point.position, {}) > kFarthest) continue;
    sum += brightestNear(scene.sampler, static_cast<int>(point.pixel.x),
                         static_cast<int>(point.pixel.y));
    ++count;
  }
  if (count < kMin || sum <= 0.0) return {};
  return {true, maths::log(sum / (count * params.line.y)), 0.0};
}

const SurfaceColour* colourOf(ColourClass c, const LightParams& params) {
  if (c == ColourClass::blue) return &params.blue;
  if (c == ColourClass::yellow) return &params.yellow;
  return c == ColourClass::pink ? &params.pink : nullptr;
}

LightSighting seenLandmarks(const Scene& scene, const Percepts& percepts,
                            const LightParams& params) {
  constexpr int kAcross = 5;  // pixels of a landmark's box, and as many down
  constexpr int kMin = 8;     // of its colours
  Sums sums;
  for (const LandmarkPercept& mark : percepts.landmarks) {
    for (int i = 0; i < kAcross * kAcross; ++i) {
      const int column = i % kAcross;
      const int row = i / kAcross;
      const double right = (column + 0.5) / kAcross;
      const double down = (row + 0.5) / kAcross;
      const int px = Sampler::pixelOf(mark.box.left + right * (mark.box.right - mark.box.left));
      const int py = Sampler::pixelOf(mark.box.top + down * (mark.box.bottom - mark.box.top));
      if (!Sampler::usable(px, py)) continue;
      const Yuv pixel = scene.sampler.corrected(px, py);
      if (const auto* colour = colourOf(scene.sampler.classOf(pixel), params))
        sums.add(pixel, *colour);
    }
  }
  const LightSighting seen = sums.ratio(kMin);
  const bool alike =
      std::fabs(seen.brightness) < params.unlike && std::fabs(seen.colour) < params.unlike;
  return alike ? seen : LightSighting{};
}

}  // namespace

LightSightings seenLight(const Scene& scene, const Percepts& percepts, const LightParams& params) {
  return {seenCarpet(scene, params), seenLines(scene, percepts, params),
          seenLandmarks(scene, percepts, params)};
}

}  // namespace kelpie::vision
