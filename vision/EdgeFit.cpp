// SPDX-License-Identifier: Apache-2.0
#include "vision/EdgeFit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <utility>

#include "robot/core/Maths.h"
#include "robot/core/Random.h"
#include "vision/Refusal.h"

namespace kelpie::vision {
namespace {

struct Search {
  const EdgeFeatures& features;
  const ImageLevel& level;
  const FieldEdgeParams& params;
  VisionCounts& counts;
  Random random;
};

// The edges that bound the carpet and what speaks for them, in inliers.
struct Outline {
  EdgeLines lines;
  double gain = -1e6;
};

// How far a point is off the carpet, and the edge that says so: the carpet is inside all of them.
struct Place {
  double beyond = -1e6;
  std::size_t edge = 0;
};

Place placeOf(const EdgeLines& lines, PixelPoint p) {
  Place place;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const double beyond = lines[i].beyond(p);
    if (beyond > place.beyond) place = {beyond, i};
  }
  return place;
}

// Inliers weighted by closeness, less a fine for each place of the carpet that is seen beyond.
double gainOf(const Search& search, const EdgeLines& lines) {
  const double t = search.params.tolerance;
  const double perSquare = 1.0 / (t * t);
  double gain = 0.0;
  for (const EdgeFeature& f : search.features) {
    const double d = placeOf(lines, f.at).beyond;
    if (d > t) {
      gain -= search.params.abovePenalty;
    } else if (d > -t && !f.open) {
      gain += f.weight * (1.0 - d * d * perSquare);
    }
  }
  return gain;
}

EdgeLines refitted(const Search& search, const EdgeLines& lines, double tolerance) {
  std::array<EdgeMoments, EdgeLines::kCapacity> moments;
  for (const EdgeFeature& f : search.features) {
    const Place place = placeOf(lines, f.at);
    if (!f.open && std::fabs(place.beyond) <= tolerance) moments[place.edge].add(f.at, f.weight);
  }
  EdgeLines better = lines;
  for (std::size_t i = 0; i < lines.size(); ++i)
    if (moments[i].n >= 2.0) better[i] = lineOf(moments[i], search.level);
  return better;
}

// Refits, the first to a wider band: a line through two points is off at its far end.
void refine(const Search& search, Outline& outline) {
  EdgeLines lines = outline.lines;
  for (const double width : {2.0, 1.0, 1.0}) {
    lines = refitted(search, lines, width * search.params.tolerance);
    const double gain = gainOf(search, lines);
    if (gain > outline.gain) outline = {lines, gain};
  }
}

// Numbers of features that points are drawn from.
struct Pool {
  std::array<std::uint8_t, kMaxScanLines> number{};
  std::uint32_t count = 0;
};

// Whether the middle one of three features lies on the line through the others.
bool inLine(const EdgeFeature& a, const EdgeFeature& m, const EdgeFeature& b, double tolerance) {
  const double dx = b.at.x - a.at.x;
  const double dy = b.at.y - a.at.y;
  const double cross = dx * (m.at.y - a.at.y) - dy * (m.at.x - a.at.x);
  return cross * cross <= tolerance * tolerance * (dx * dx + dy * dy);
}

constexpr int kNeighbours = 3;  // to each side: nine triples

int agreement(const Search& search, const Pool& pool, int k) {
  const auto at = [&](int i) -> const EdgeFeature& {
    return search.features[pool.number[static_cast<std::size_t>(i)]];
  };
  int agreeing = 0;
  const int last = std::min(k + kNeighbours, static_cast<int>(pool.count) - 1);
  for (int a = std::max(k - kNeighbours, 0); a < k; ++a)
    for (int b = k + 1; b <= last; ++b)
      agreeing += inLine(at(a), at(k), at(b), search.params.tolerance) ? 1 : 0;
  return agreeing;
}

// The features that no line has yet, those first that lie in line with most of their neighbours.
Pool drawingPool(const Search& search, const EdgeLines& lines) {
  Pool pool;
  for (std::size_t i = 0; i < search.features.size(); ++i) {
    const EdgeFeature& f = search.features[i];
    const double beyond = placeOf(lines, f.at).beyond;
    if (!f.open && !(std::fabs(beyond) <= search.params.tolerance))
      pool.number[pool.count++] = static_cast<std::uint8_t>(i);
  }
  std::array<double, kMaxScanLines> score{};
  for (std::uint32_t k = 0; k < pool.count; ++k) {
    const std::uint8_t i = pool.number[k];
    score[i] = agreement(search, pool, static_cast<int>(k)) * search.features[i].weight;
  }
  std::sort(pool.number.begin(), pool.number.begin() + pool.count,
            [&](std::uint8_t a, std::uint8_t b) {
              return score[a] != score[b] ? score[a] > score[b] : a < b;
            });
  return pool;
}

constexpr std::uint32_t kFirstPool = 6;  // features to draw from in the first round; 3 more in each
constexpr int kLeastGap = 4;             // scan lines between two points, if it can be had

struct Pair {
  std::uint8_t a = 0;
  std::uint8_t b = 0;
};

Pair drawn(Search& search, const Pool& pool, int round) {
  const std::uint32_t reach =
      std::min(pool.count, kFirstPool + 3U * static_cast<std::uint32_t>(round));
  Pair pair;
  pair.a = pool.number[search.random.index(reach)];
  for (int again = 0; again < 5; ++again) {
    pair.b = pool.number[search.random.index(reach)];
    if (std::abs(pair.a - pair.b) >= kLeastGap) break;
  }
  return pair;
}

constexpr double kPromising = 0.6;  // of the best gain so far

// The best outline of the known lines and one more, through features that are on none of `passed`.
Outline withOneMore(Search& search, const EdgeLines& known, const EdgeLines& passed) {
  Outline best;
  const Pool pool = drawingPool(search, passed);
  if (pool.count < 2) return best;
  for (int round = 0; round < search.params.rounds; ++round) {
    const Pair pair = drawn(search, pool, round);
    if (pair.a == pair.b) continue;
    Outline now{known, 0.0};
    now.lines.push_back(
        lineThrough(search.features[pair.a].at, search.features[pair.b].at, search.level));
    now.gain = gainOf(search, now.lines);
    if (now.gain < kPromising * best.gain) continue;
    refine(search, now);
    if (now.gain > best.gain) best = now;
  }
  return best;
}

constexpr double kBendBand = 2.0;     // tolerances to both sides in which a bend is looked for
constexpr std::size_t kLeastArm = 3;  // features on each arm

using Numbers = FixedVector<std::uint8_t, kMaxScanLines>;

// Where two lines through the features before and after it fit best.
std::size_t bestBend(const EdgeFeatures& features, const Numbers& near) {
  std::array<double, kMaxScanLines> before{};
  EdgeMoments left;
  for (std::size_t k = 0; k < near.size(); ++k) {
    left.add(features[near[k]].at, features[near[k]].weight);
    before[k] = left.leastSquares();
  }
  EdgeMoments right;
  std::size_t best = 0;
  double least = 1e12;
  for (std::size_t k = near.size() - 1; k >= kLeastArm; --k) {
    right.add(features[near[k]].at, features[near[k]].weight);
    const double squares = before[k - 1] + right.leastSquares();
    if (near.size() - k < kLeastArm || squares >= least) continue;
    least = squares;
    best = k;
  }
  return best;
}

// A flat corner looks like one line through both arms: the same line, bent where that fits best.
Outline bent(const Search& search, const EdgeLines& known, std::size_t which) {
  Outline outline;
  Numbers near;
  for (std::size_t i = 0; i < search.features.size(); ++i) {
    const EdgeFeature& f = search.features[i];
    const Place place = placeOf(known, f.at);
    if (!f.open && place.edge == which &&
        std::fabs(place.beyond) <= kBendBand * search.params.tolerance)
      near.push_back(static_cast<std::uint8_t>(i));
  }
  if (near.size() < 2 * kLeastArm) return outline;
  const std::size_t bend = bestBend(search.features, near);
  std::array<EdgeMoments, 2> arms;
  for (std::size_t k = 0; k < near.size(); ++k)
    arms[k < bend ? 0 : 1].add(search.features[near[k]].at, search.features[near[k]].weight);
  outline.lines = known;
  outline.lines[which] = lineOf(arms[0], search.level);
  outline.lines.push_back(lineOf(arms[1], search.level));
  outline.gain = gainOf(search, outline.lines);
  refine(search, outline);
  return outline;
}

// Counts the features on each line.
void measure(const Search& search, EdgeLines& lines) {
  std::array<double, EdgeLines::kCapacity> squares{};
  for (EdgeLine& line : lines) line.support = 0;
  for (const EdgeFeature& f : search.features) {
    const Place place = placeOf(lines, f.at);
    if (f.open || !(std::fabs(place.beyond) <= search.params.tolerance)) continue;
    ++lines[place.edge].support;
    squares[place.edge] += place.beyond * place.beyond;
  }
  for (std::size_t i = 0; i < lines.size(); ++i)
    if (lines[i].support > 0)
      lines[i].rms = std::sqrt(squares[i] / static_cast<double>(lines[i].support));
}

bool squareToNeighbours(const Search& search, const EdgeLines& lines) {
  // Three edges in one image are two ends of a side: the outer two are parallel, not square.
  for (std::size_t i = 0; i < lines.size(); ++i) {
    int square = 0;
    for (std::size_t k = 0; k < lines.size(); ++k)
      square +=
          i != k && groundCosine(lines[i], lines[k], search.level) <= search.params.maxCornerCosine
              ? 1
              : 0;
    if (square == 0) return false;
  }
  return true;
}

constexpr double kDeniedByNoise = 1.0;  // features
constexpr double kLeastNoise = 0.09;    // px^2: features lie on whole pixels
constexpr double kComparable = 0.7;     // of the best line's support

bool supported(const EdgeLines& lines, const FieldEdgeParams& params) {
  return std::all_of(lines.begin(), lines.end(), [&](const EdgeLine& line) {
    return static_cast<double>(line.support) >= params.minCornerSupport;
  });
}

// Features beyond the outline: carpet that it would deny.
double denied(const Search& search, const EdgeLines& lines) {
  double count = 0.0;
  for (const EdgeFeature& f : search.features)
    count += placeOf(lines, f.at).beyond > search.params.tolerance ? 1.0 : 0.0;
  return count;
}

// px^2, mean over the features on the outline.
double noiseOf(const EdgeLines& lines) {
  double squares = 0.0;
  double count = 0.0;
  for (const EdgeLine& line : lines) {
    squares += static_cast<double>(line.support) * line.rms * line.rms;
    count += static_cast<double>(line.support);
  }
  return count > 0.0 ? std::fmax(squares / count, kLeastNoise) : kLeastNoise;
}

// A corner: each edge has its features, none is denied, the edges are square on the ground.
bool isCorner(const Search& search, const Outline& before, const Outline& after) {
  const bool corner =
      supported(after.lines, search.params) &&
      denied(search, after.lines) <= denied(search, before.lines) + kDeniedByNoise &&
      squareToNeighbours(search, after.lines);
  if (!corner) refuse(search.counts, Refusal::edgeNoCorner);
  return corner;
}

// A new edge must win inliers.
bool winsInliers(const Search& search, const Outline& before, const Outline& after) {
  return after.gain >= before.gain + search.params.minCornerGain;
}

// A bend wins few, since one line runs near both arms; it must fit much better than the noise
// explains.
bool fitsBetter(const Search& search, const Outline& before, const Outline& after) {
  const double squares = (after.gain - before.gain) * maths::square(search.params.tolerance);
  return squares >= search.params.minBendRatio * noiseOf(after.lines);
}

// The outline with one edge more, or as it is.
Outline furtherEdge(Search& search, const Outline& best) {
  Outline found = best;
  Outline more = withOneMore(search, best.lines, best.lines);
  measure(search, more.lines);
  if (winsInliers(search, best, more) && isCorner(search, best, more)) found = more;
  for (std::size_t i = 0; i < best.lines.size(); ++i) {
    Outline bend = bent(search, best.lines, i);
    measure(search, bend.lines);
    if (bend.gain > found.gain && fitsBetter(search, best, bend) && isCorner(search, best, bend))
      found = bend;
  }
  return found;
}

// Of two lines with about the same support, the one that the other does not deny: the carpet is
// seen up to it, and the other is the foot of something that stands there.
Outline firstEdge(Search& search) {
  Outline best = withOneMore(search, {}, {});
  if (best.lines.empty()) return best;
  Outline other = withOneMore(search, {}, best.lines);
  if (other.lines.empty()) return best;
  measure(search, best.lines);
  measure(search, other.lines);
  const auto support = static_cast<double>(best.lines[0].support);
  if (static_cast<double>(other.lines[0].support) < kComparable * support) return best;
  return denied(search, other.lines) < denied(search, best.lines) ? other : best;
}

// By exchange: std::sort of so few is a warning, std::stable_sort takes memory.
void strongestFirst(EdgeLines& lines) {
  for (std::size_t i = 0; i < lines.size(); ++i)
    for (std::size_t k = i + 1; k < lines.size(); ++k)
      if (lines[k].support > lines[i].support) std::swap(lines[i], lines[k]);
}

}  // namespace

EdgeLines fitEdgeLines(const EdgeFeatures& features, const ImageLevel& level,
                       const FieldEdgeParams& params, VisionCounts& counts) {
  Search search{features, level, params, counts, Random(params.seed)};
  double solid = 0.0;
  for (const EdgeFeature& f : features) solid += f.open ? 0.0 : 1.0;
  Outline best = firstEdge(search);
  if (best.lines.empty()) return best.lines;
  while (!best.lines.full()) {
    const Outline more = furtherEdge(search, best);
    if (more.gain <= best.gain) break;
    best = more;
  }
  measure(search, best.lines);
  double support = 0.0;
  for (const EdgeLine& line : best.lines) support += static_cast<double>(line.support);
  if (support < params.minSupport || support < params.minShare * solid) {
    refuse(counts, Refusal::edgeFewFeatures);
    return {};
  }
  strongestFirst(best.lines);
  return best.lines;
}

}  // namespace kelpie::vision
