// SPDX-License-Identifier: Apache-2.0
#include "vision/light/LightSightings.h"

#include <algorithm>
#include <cmath>

#include "robot/core/Maths.h"

namespace kelpie::vision {
namespace {

struct Chroma {
  double cr = 0.0;
  double cb = 0.0;
  double norm() const { return std::sqrt(cr * cr + cb * cb); }
};

Chroma chromaOf(Yuv c) { return {c.cr - kNeutralChroma, c.cb - kNeutralChroma}; }
double dot(const Chroma& a, const Chroma& b) { return a.cr * b.cr + a.cb * b.cb; }

// A surface in the light that the table was made for.
struct Surface {
  double y = 0.0;
  Chroma chroma;
  double norm = 0.0;  // of the chroma
};

Surface surfaceOf(const SurfaceColour& c) {
  const Chroma chroma{c.cr - kNeutralChroma, c.cb - kNeutralChroma};
  return {c.y, chroma, chroma.norm()};
}

// Of pixels of one kind: their brightness, their colour in the expected direction, and both as
// expected.
struct Sums {
  int count = 0;
  double y = 0.0;
  double expectedY = 0.0;
  double chroma = 0.0;
  double expectedChroma = 0.0;

  void add(Yuv pixel, const Surface& expected) {
    ++count;
    y += pixel.y;
    expectedY += expected.y;
    chroma += dot(chromaOf(pixel), expected.chroma) / expected.norm;
    expectedChroma += expected.norm;
  }
  LightSighting ratio(int least) const {
    if (count < least || y <= 0.0 || chroma <= 0.0) return {};
    return {true, maths::log(y / expectedY), maths::log(chroma / expectedChroma)};
  }
};

// Of the carpet's chroma in the darkest light there are some 8 levels left.
bool isCarpets(const Chroma& chroma, const Surface& carpet) {
  constexpr double kMinChroma = 5.0;  // levels
  constexpr double kCosine = 0.85;    // of 32 deg
  const double norm = chroma.norm();
  return norm > kMinChroma && dot(chroma, carpet.chroma) > kCosine * norm * carpet.norm;
}

LightSighting seenCarpet(const Scene& scene, const LightParams& params) {
  constexpr int kColumnStep = 13;  // px; 15 columns
  constexpr int kRows = 6;         // of each column
  constexpr double kBelow = 8.0;   // px below the horizon and the field edge
  constexpr int kMin = 15;         // pixels of the carpet
  const Surface carpet = surfaceOf(params.carpet);
  Sums sums;
  for (int px = kCoarseLeft + 2; px < kUsableRight; px += kColumnStep) {
    const double top = std::max(carpetRow(scene, px) + kBelow, kUsableTop * 1.0);
    const double step = (kUsableBottom - top) / kRows;
    if (step < 1.0) continue;
    for (int row = 0; row < kRows; ++row) {
      const Yuv pixel = scene.sampler.corrected(px, static_cast<int>(top + row * step));
      if (isCarpets(chromaOf(pixel), carpet)) sums.add(pixel, carpet);
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

// What landmarks are painted with.
struct LandmarkSurfaces {
  Surface blue, yellow, pink;

  explicit LandmarkSurfaces(const LightParams& params)
      : blue(surfaceOf(params.blue)),
        yellow(surfaceOf(params.yellow)),
        pink(surfaceOf(params.pink)) {}
  const Surface* of(ColourClass c) const {
    if (c == ColourClass::blue) return &blue;
    if (c == ColourClass::yellow) return &yellow;
    return c == ColourClass::pink ? &pink : nullptr;
  }
};

LightSighting seenLandmarks(const Scene& scene, const Percepts& percepts,
                            const LightParams& params) {
  constexpr int kAcross = 5;  // pixels of a landmark's box, and as many down
  constexpr int kMin = 8;     // of its colours
  const LandmarkSurfaces surfaces(params);
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
      if (const Surface* surface = surfaces.of(scene.sampler.classOf(pixel)))
        sums.add(pixel, *surface);
    }
  }
  return sums.ratio(kMin);
}

bool isAlike(const LightSighting& seen, const LightParams& params) {
  return std::fabs(seen.brightness) < params.unlike && std::fabs(seen.colour) < params.unlike;
}

// In glare a landmark is brighter and less colourful; in any light of the whole field it is as much
// more of both. A landmark should show above a field edge.
LandmarkLook lookOf(const LightSighting& landmarks, const Percepts& percepts,
                    const LightParams& params) {
  if (!percepts.landmarks.empty())
    return landmarks.brightness - landmarks.colour > params.unlike ? LandmarkLook::glare
                                                                   : LandmarkLook::even;
  return percepts.fieldEdges.empty() ? LandmarkLook::unknown : LandmarkLook::missing;
}

}  // namespace

SeenLight seenLight(const Scene& scene, const Percepts& percepts, const LightParams& params) {
  const LightSighting landmarks = seenLandmarks(scene, percepts, params);
  return {{seenCarpet(scene, params), seenLines(scene, percepts, params),
           isAlike(landmarks, params) ? landmarks : LightSighting{}},
          lookOf(landmarks, percepts, params)};
}

}  // namespace kelpie::vision
