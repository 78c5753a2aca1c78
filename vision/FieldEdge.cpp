// SPDX-License-Identifier: Apache-2.0
#include "vision/FieldEdge.h"

#include <algorithm>
#include <cmath>

#include "robot/core/Random.h"

namespace kelpie::vision {
namespace {

constexpr int kLatticeLeft = 4;
constexpr int kLatticeTop = 4;
constexpr int kLatticeStep = 2;

constexpr int kColumnStep = 4;
constexpr int kRunSamples = 3;    // greens in a row that begin the field
constexpr int kWidestLine = 24;   // px, of a white line before the robot's feet
constexpr int kBelowSamples = 8;  // samples below that must be mostly green

bool isGreen(const Sampler& sampler, int px, int py) {
  return py < kUsableBottom && sampler.classAt(px, py) == ColourClass::green;
}

bool fieldBegins(const Sampler& sampler, int px, int py, double minGreen) {
  for (int i = 0; i < kRunSamples; ++i) {
    if (!isGreen(sampler, px, py + i * kLatticeStep)) return false;
  }
  int green = 0;
  int seen = 0;
  for (int i = 0; i < kBelowSamples && py + i * kLatticeStep < kUsableBottom; ++i, ++seen) {
    green += isGreen(sampler, px, py + i * kLatticeStep) ? 1 : 0;
  }
  return green >= minGreen * seen;
}

// A ball, or a line that leaves through the image's top, hides carpet, not its end.
bool onlyHidesCarpet(const Sampler& sampler, int px, int py) {
  const ColourClass above = sampler.classAt(px, py - kLatticeStep);
  const ColourClass further = sampler.classAt(px, std::max(py - 2 * kLatticeStep, kLatticeTop));
  if (above == ColourClass::orange || further == ColourClass::orange) return true;
  if (py - kLatticeTop > kWidestLine) return false;
  for (int row = kLatticeTop; row < py - kLatticeStep; row += kLatticeStep) {
    if (sampler.classAt(px, row) != ColourClass::white) return false;
  }
  return true;
}

struct Line {
  double slope = 0.0;
  double offset = 0.0;
  double at(double x) const { return offset + slope * x; }
};

std::size_t inliers(const EdgeFeatures& features, const Line& line, double tolerance) {
  std::size_t count = 0;
  for (const PixelPoint& p : features) {
    if (std::fabs(p.y - line.at(p.x)) <= tolerance) ++count;
  }
  return count;
}

Line refined(const EdgeFeatures& features, const Line& line, double tolerance) {
  double n = 0.0, sx = 0.0, sy = 0.0, sxx = 0.0, sxy = 0.0;
  for (const PixelPoint& p : features) {
    if (std::fabs(p.y - line.at(p.x)) > tolerance) continue;
    n += 1.0;
    sx += p.x;
    sy += p.y;
    sxx += p.x * p.x;
    sxy += p.x * p.y;
  }
  const double spread = n * sxx - sx * sx;
  if (spread <= 0.0) return line;
  const double slope = (n * sxy - sx * sy) / spread;
  return {slope, (sy - slope * sx) / n};
}

Line through(PixelPoint a, PixelPoint b) {
  const double slope = (b.y - a.y) / (b.x - a.x);
  return {slope, a.y - slope * a.x};
}

}  // namespace

EdgeFeatures fieldEdgeFeatures(const Sampler& sampler, const FieldEdgeParams& params) {
  EdgeFeatures features;
  for (int px = kLatticeLeft; px < kUsableRight; px += kColumnStep) {
    int py = kLatticeTop;
    while (py < kUsableBottom && !fieldBegins(sampler, px, py, params.minGreen)) py += kLatticeStep;
    // Green from the first row on: the edge is above the image.
    if (py == kLatticeTop || py >= kUsableBottom || onlyHidesCarpet(sampler, px, py)) continue;
    features.push_back({px + 0.5, py - 0.5});
  }
  return features;
}

FieldEdgePercept fitFieldEdge(const EdgeFeatures& features, const FieldEdgeParams& params) {
  const auto count = static_cast<std::uint32_t>(features.size());
  if (count < 2) return {};
  Random random(params.seed);
  Line best;
  std::size_t support = 0;
  for (int round = 0; round < params.rounds; ++round) {
    const std::uint32_t a = random.index(count);
    const std::uint32_t b = random.index(count - 1);
    const Line line = through(features[a], features[b < a ? b : b + 1]);
    const std::size_t now = inliers(features, line, params.tolerance);
    if (now <= support) continue;
    support = now;
    best = line;
  }
  best = refined(features, best, params.tolerance);
  support = inliers(features, best, params.tolerance);
  if (static_cast<double>(support) < params.minColumns) return {};
  if (static_cast<double>(support) < params.minShare * static_cast<double>(count)) return {};
  return {true, best.at(0.0), best.at(kImageWidth)};
}

}  // namespace kelpie::vision
