// SPDX-License-Identifier: Apache-2.0
#include "vision/EdgeFit.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "robot/core/Maths.h"
#include "robot/core/Random.h"

namespace kelpie::vision {
namespace {

// One search: the features, and those that an edge may still win.
struct Search {
  const EdgeFeatures& features;
  const ImageLevel& level;
  const FieldEdgeParams& params;
  FixedVector<std::uint8_t, kMaxScanLines> free;   // by number, in the order of the scan lines
  FixedVector<std::uint8_t, kMaxScanLines> taken;  // on edges found before
};

// A line and what speaks for it, in inliers.
struct Hypothesis {
  EdgeLine line;
  double gain = -1e6;
};

EdgeLine oriented(double nx, double ny, PixelPoint on, const ImageLevel& level) {
  const double side = nx * level.upX + ny * level.upY < 0.0 ? -1.0 : 1.0;
  return {side * nx, side * ny, side * (nx * on.x + ny * on.y), 0, 0.0};
}

EdgeLine through(PixelPoint a, PixelPoint b, const ImageLevel& level) {
  const double dx = b.x - a.x;
  const double dy = b.y - a.y;
  const double norm = std::sqrt(dx * dx + dy * dy);
  if (!(norm > 1e-9)) return oriented(level.upX, level.upY, a, level);
  return oriented(dy / norm, -dx / norm, a, level);
}

// Inliers weighted by closeness, less a fine for each place of the carpet that is seen beyond.
double gainOf(const Search& search, const EdgeLine& line) {
  const double t = search.params.tolerance;
  const double perSquare = 1.0 / (t * t);
  double gain = 0.0;
  for (const std::uint8_t i : search.free) {
    const EdgeFeature& f = search.features[i];
    const double d = line.beyond(f.at);
    if (d > t) {
      gain -= search.params.abovePenalty;
    } else if (d > -t && !f.open) {
      gain += 1.0 - d * d * perSquare;
    }
  }
  // A second edge must not cut off what is known to be carpet.
  for (const std::uint8_t i : search.taken) {
    if (line.beyond(search.features[i].at) > t) gain -= 1.0;
  }
  return gain;
}

struct Moments {
  double n = 0.0, x = 0.0, y = 0.0, xx = 0.0, xy = 0.0, yy = 0.0;

  void add(PixelPoint p) {
    n += 1.0;
    x += p.x;
    y += p.y;
    xx += p.x * p.x;
    xy += p.x * p.y;
    yy += p.y * p.y;
  }
};

Moments inliersOf(const Search& search, const EdgeLine& line, double tolerance) {
  Moments m;
  for (const std::uint8_t i : search.free) {
    const EdgeFeature& f = search.features[i];
    if (!f.open && std::fabs(line.beyond(f.at)) <= tolerance) m.add(f.at);
  }
  return m;
}

// The line of least squared distance: its normal is the direction of least spread.
EdgeLine fitted(const Moments& m, const ImageLevel& level) {
  const PixelPoint mean{m.x / m.n, m.y / m.n};
  const double xx = m.xx / m.n - mean.x * mean.x;
  const double xy = m.xy / m.n - mean.x * mean.y;
  const double yy = m.yy / m.n - mean.y * mean.y;
  const double half = 0.5 * (xx - yy);
  const double root = std::sqrt(half * half + xy * xy);
  const double least = 0.5 * (xx + yy) - root;
  // Of the two rows of (S - least I) n = 0 the longer one is far from 0/0.
  const double ax = xx - least;
  const double by = yy - least;
  const double nx = ax > by ? -xy : by;
  const double ny = ax > by ? ax : -xy;
  const double norm = std::sqrt(nx * nx + ny * ny);
  if (!(norm > 1e-9)) return oriented(level.upX, level.upY, mean, level);
  EdgeLine line = oriented(nx / norm, ny / norm, mean, level);
  line.rms = std::sqrt(std::fmax(0.0, least));
  return line;
}

// Two refits, the first to a wider band: a line through two points is off at its far end.
void refine(const Search& search, Hypothesis& h) {
  for (const double width : {2.0, 1.0, 1.0}) {
    const Moments m = inliersOf(search, h.line, width * search.params.tolerance);
    if (m.n < 3.0) return;
    const EdgeLine line = fitted(m, search.level);
    const double gain = gainOf(search, line);
    if (gain > h.gain) h = {line, gain};
  }
}

using Order = std::array<std::uint8_t, kMaxScanLines>;

// Whether the middle one of three features lies on the line through the others.
bool inLine(const EdgeFeature& a, const EdgeFeature& m, const EdgeFeature& b, double tolerance) {
  const double dx = b.at.x - a.at.x;
  const double dy = b.at.y - a.at.y;
  const double cross = dx * (m.at.y - a.at.y) - dy * (m.at.x - a.at.x);
  return cross * cross <= tolerance * tolerance * (dx * dx + dy * dy);
}

constexpr int kNeighbours = 3;  // to each side: nine triples

// The features that no edge has yet, those first that lie in line with most of their neighbours.
std::size_t drawingOrder(const Search& search, Order& order) {
  std::array<std::uint8_t, kMaxScanLines> solid{};
  int count = 0;
  for (const std::uint8_t i : search.free)
    if (!search.features[i].open) solid[static_cast<std::size_t>(count++)] = i;
  std::array<int, kMaxScanLines> agreeing{};
  const auto feature = [&](int k) -> const EdgeFeature& {
    return search.features[solid[static_cast<std::size_t>(k)]];
  };
  for (int k = 0; k < count; ++k)
    for (int a = std::max(k - kNeighbours, 0); a < k; ++a)
      for (int b = k + 1; b <= std::min(k + kNeighbours, count - 1); ++b)
        if (inLine(feature(a), feature(k), feature(b), search.params.tolerance))
          ++agreeing[solid[static_cast<std::size_t>(k)]];
  std::copy_n(solid.begin(), count, order.begin());
  std::sort(order.begin(), order.begin() + count, [&](std::uint8_t a, std::uint8_t b) {
    return agreeing[a] != agreeing[b] ? agreeing[a] > agreeing[b] : a < b;
  });
  return static_cast<std::size_t>(count);
}

constexpr std::uint32_t kFirstPool = 6;  // points to draw from in the first round; 3 more in each
constexpr int kLeastGap = 4;             // scan lines between the two points, if it can be had
constexpr double kPromising = 0.6;       // of the best gain so far

Hypothesis sampled(const Search& search) {
  Order order;
  const auto count = static_cast<std::uint32_t>(drawingOrder(search, order));
  Hypothesis best;
  if (count < 2) return best;
  Random random(search.params.seed);
  for (int round = 0; round < search.params.rounds; ++round) {
    const std::uint32_t pool = std::min(count, kFirstPool + 3U * static_cast<std::uint32_t>(round));
    const std::uint8_t a = order[random.index(pool)];
    std::uint8_t b = order[random.index(pool)];
    for (int again = 0; again < 4 && std::abs(a - b) < kLeastGap; ++again)
      b = order[random.index(pool)];
    if (a == b) continue;
    Hypothesis h;
    h.line = through(search.features[a].at, search.features[b].at, search.level);
    h.gain = gainOf(search, h.line);
    if (h.gain < kPromising * best.gain) continue;
    refine(search, h);
    if (h.gain > best.gain) best = h;
  }
  return best;
}

// Moves the inliers from the free ones to the taken ones; their number.
std::size_t take(Search& search, const EdgeLine& line) {
  FixedVector<std::uint8_t, kMaxScanLines> left;
  std::size_t support = 0;
  for (const std::uint8_t i : search.free) {
    const EdgeFeature& f = search.features[i];
    if (!f.open && std::fabs(line.beyond(f.at)) <= search.params.tolerance) {
      search.taken.push_back(i);
      ++support;
    } else {
      left.push_back(i);
    }
  }
  search.free = left;
  return support;
}

}  // namespace

EdgeLines fitEdgeLines(const EdgeFeatures& features, const ImageLevel& level,
                       const FieldEdgeParams& params) {
  EdgeLines lines;
  Search search{features, level, params, {}, {}};
  double solid = 0.0;
  for (std::size_t i = 0; i < features.size(); ++i) {
    search.free.push_back(static_cast<std::uint8_t>(i));
    solid += features[i].open ? 0.0 : 1.0;
  }
  Hypothesis h = sampled(search);
  h.line.support = take(search, h.line);
  const auto support = static_cast<double>(h.line.support);
  if (support < params.minSupport || support < params.minShare * solid) return lines;
  lines.push_back(h.line);
  return lines;
}

}  // namespace kelpie::vision
