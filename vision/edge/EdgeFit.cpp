// SPDX-License-Identifier: Apache-2.0
#include "vision/edge/EdgeFit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <utility>

#include "robot/core/Maths.h"
#include "robot/core/Random.h"
#include "robot/core/ScratchVector.h"
#include "vision/Refusal.h"

namespace kelpie::vision {
namespace {

struct EdgeSearch {
  EdgeEvidence evidence;
  VisionCounts& counts;
  Random random;
};

// Indices of the features that points are drawn from.
struct Pool {
  std::array<std::uint8_t, kMaxScanLines> indices{};
  std::uint32_t count = 0;
  double weight = 0.0;  // of all
};

// Whether the middle one of three features lies on the line through the others.
bool inLine(const EdgeFeature& a, const EdgeFeature& m, const EdgeFeature& b, double tolerance) {
  const double dx = b.at.x - a.at.x;
  const double dy = b.at.y - a.at.y;
  const double cross = dx * (m.at.y - a.at.y) - dy * (m.at.x - a.at.x);
  return cross * cross <= tolerance * tolerance * (dx * dx + dy * dy);
}

constexpr int kNeighbours = 3;  // to each side: nine triples

int agreement(const EdgeEvidence& evidence, const Pool& pool, int k) {
  const auto at = [&](int i) -> const EdgeFeature& {
    return evidence.features[pool.indices[static_cast<std::size_t>(i)]];
  };
  int agreeing = 0;
  const int last = std::min(k + kNeighbours, static_cast<int>(pool.count) - 1);
  for (int a = std::max(k - kNeighbours, 0); a < k; ++a)
    for (int b = k + 1; b <= last; ++b)
      agreeing += inLine(at(a), at(k), at(b), evidence.params.tolerance) ? 1 : 0;
  return agreeing;
}

// The features that are on none of the lines.
Pool freeFeatures(const EdgeEvidence& evidence, const EdgeLines& lines) {
  Pool pool;
  for (std::size_t i = 0; i < evidence.features.size(); ++i) {
    const EdgeFeature& f = evidence.features[i];
    if (f.open) continue;
    if (!lines.empty() && std::fabs(placeOf(lines, f.at).distance) <= evidence.params.tolerance)
      continue;
    pool.indices[pool.count++] = static_cast<std::uint8_t>(i);
    pool.weight += f.weight;
  }
  return pool;
}

// Brings those features to the front that lie in line with most of their neighbours.
void sortForDrawing(const EdgeEvidence& evidence, Pool& pool) {
  std::array<double, kMaxScanLines> score{};
  for (std::uint32_t k = 0; k < pool.count; ++k) {
    const std::uint8_t i = pool.indices[k];
    score[i] = agreement(evidence, pool, static_cast<int>(k)) * evidence.features[i].weight;
  }
  std::sort(pool.indices.begin(), pool.indices.begin() + pool.count,
            [&](std::uint8_t a, std::uint8_t b) {
              return score[a] != score[b] ? score[a] > score[b] : a < b;
            });
}

constexpr std::uint32_t kFirstPool = 6;   // features to draw from in the first round,
constexpr std::uint32_t kPoolGrowth = 3;  // and so many more in each
constexpr int kMinGap = 4;                // scan lines between two points, if possible
constexpr int kMaxDraws = 5;              // of the second point for such a gap

struct Pair {
  std::uint8_t a = 0;
  std::uint8_t b = 0;
};

Pair drawn(EdgeSearch& search, const Pool& pool, int round) {
  const std::uint32_t reach =
      std::min(pool.count, kFirstPool + kPoolGrowth * static_cast<std::uint32_t>(round));
  Pair pair;
  pair.a = pool.indices[search.random.index(reach)];
  for (int again = 0; again < kMaxDraws; ++again) {
    pair.b = pool.indices[search.random.index(reach)];
    if (std::abs(pair.a - pair.b) >= kMinGap) break;
  }
  return pair;
}

constexpr double kRefineAboveShare = 0.8;   // of the best score so far
constexpr double kFirstWidth = 2.0;         // tolerances, while the line may be off at its far end
constexpr double kStopAtScoreShare = 0.75;  // of the most that the free features could give

// The best outline of the known lines and one more, through features of the pool; `known` as it is
// when the pool is too poor to give `minScore` more.
Outline withOneMore(EdgeSearch& search, const Outline& known, Pool pool, double minScore) {
  const EdgeEvidence& evidence = search.evidence;
  Outline best = known;
  if (pool.count < 2 || pool.weight < minScore) return best;
  sortForDrawing(evidence, pool);
  bool found = false;
  for (int round = 0; round < evidence.params.rounds; ++round) {
    const Pair pair = drawn(search, pool, round);
    if (pair.a == pair.b) continue;
    Outline now = known;
    now.lines.push_back(
        lineThrough(evidence.features[pair.a].at, evidence.features[pair.b].at, evidence.frame));
    now.score = scoreOf(evidence, now.lines);
    if (found && now.score < kRefineAboveShare * best.score) continue;
    refine(evidence, kFirstWidth, now);
    if (found && now.score <= best.score) continue;
    found = true;
    best = now;
    if (best.score - known.score >= kStopAtScoreShare * pool.weight) break;
  }
  if (found && refine(evidence, 1.0, best)) refine(evidence, 1.0, best);
  return best;
}

constexpr double kBendHint = 0.5;   // of the ratio, before outliers nearby are sorted out
constexpr double kBendBand = 2.0;   // tolerances to both sides in which a bend is looked for
constexpr std::size_t kMinArm = 3;  // features on each arm
constexpr double kNoBend = 1e12;    // px^2, more than any two lines leave

using Indices = ScratchVector<std::uint8_t, kMaxScanLines>;

struct Bend {
  std::size_t at = 0;     // number of features on the first arm
  double squares = 0.0;   // px^2, of both arms
  double straight = 0.0;  // px^2, of one line instead
};

// px^2, of one line through all of them.
double straightSquares(const EdgeFeatures& features, const Indices& near) {
  EdgeMoments all;
  for (const std::uint8_t k : near) all.add(features[k].at, features[k].weight);
  return all.leastSquares();
}

// Where two lines through the features before and after it fit best.
Bend bestBend(const EdgeFeatures& features, const Indices& near) {
  std::array<double, kMaxScanLines> before{};
  EdgeMoments left;
  for (std::size_t k = 0; k < near.size(); ++k) {
    left.add(features[near[k]].at, features[near[k]].weight);
    before[k] = left.leastSquares();
  }
  EdgeMoments right;
  Bend best{0, kNoBend, before[near.size() - 1]};
  for (std::size_t k = near.size() - 1; k >= kMinArm; --k) {
    right.add(features[near[k]].at, features[near[k]].weight);
    const double squares = before[k - 1] + right.leastSquares();
    if (near.size() - k < kMinArm || squares >= best.squares) continue;
    best.at = k;
    best.squares = squares;
  }
  return best;
}

// A flat corner looks like one line through both arms: the same line, bent where that fits best.
Outline bent(const EdgeEvidence& evidence, const EdgeLines& known, std::size_t which) {
  Outline outline;
  Indices near;
  for (std::size_t i = 0; i < evidence.features.size(); ++i) {
    const EdgeFeature& f = evidence.features[i];
    const EdgePlace place = placeOf(known, f.at);
    if (!f.open && place.edge == which &&
        std::fabs(place.distance) <= kBendBand * evidence.params.tolerance)
      near.push_back(static_cast<std::uint8_t>(i));
  }
  if (near.size() < 2 * kMinArm) return outline;
  // A straight line, as most are: it needs no refit, nor a search for where it might bend.
  const auto count = static_cast<double>(near.size());
  const double hint = kBendHint * evidence.params.minBendRatio;
  if (straightSquares(evidence.features, near) < hint * kMinNoise) return outline;
  const Bend bend = bestBend(evidence.features, near);
  const double noise = std::fmax(bend.squares, kMinNoise * count);
  if ((bend.straight - bend.squares) * count < hint * noise) return outline;
  std::array<EdgeMoments, 2> arms;
  for (std::size_t k = 0; k < near.size(); ++k)
    arms[k < bend.at ? 0 : 1].add(evidence.features[near[k]].at, evidence.features[near[k]].weight);
  outline.lines = known;
  outline.lines[which] = lineOf(arms[0], evidence.frame);
  outline.lines.push_back(lineOf(arms[1], evidence.frame));
  outline.score = scoreOf(evidence, outline.lines);
  if (refine(evidence, 1.0, outline)) refine(evidence, 1.0, outline);
  return outline;
}

constexpr double kBeyondByNoise = 1.0;     // features
constexpr double kMinSupportShare = 0.65;  // of the best line's support

bool squareToNeighbours(const EdgeEvidence& evidence, const EdgeLines& lines) {
  // Three edges in one image are two ends of a side: the outer two are parallel, not square.
  for (std::size_t i = 0; i < lines.size(); ++i) {
    int square = 0;
    for (std::size_t k = 0; k < lines.size(); ++k)
      square += i != k && groundCosine(lines[i], lines[k], evidence.frame) <=
                              evidence.params.maxCornerCosine
                    ? 1
                    : 0;
    if (square == 0) return false;
  }
  return true;
}

constexpr std::size_t kMinOffGoal = 2;  // features on an edge that are at no goal

// Enough features on every edge. A goal alone shows none: its side walls have feet like edges, and
// its inside has a corner.
bool supported(const EdgeLines& lines, double minSupport) {
  return std::all_of(lines.begin(), lines.end(), [&](const EdgeLine& line) {
    return static_cast<double>(line.support) >= minSupport &&
           line.atGoal + kMinOffGoal <= line.support;
  });
}

// A corner: each edge has its features, no carpet is seen beyond, the edges are square on the
// ground.
bool isCorner(const EdgeSearch& search, const Outline& before, const Outline& after) {
  const bool corner = supported(after.lines, search.evidence.params.minCornerSupport) &&
                      carpetBeyond(search.evidence, after.lines) <=
                          carpetBeyond(search.evidence, before.lines) + kBeyondByNoise &&
                      squareToNeighbours(search.evidence, after.lines);
  if (!corner) refuse(search.counts, Refusal::edgeNoCorner);
  return corner;
}

// A new edge must win inliers.
bool winsInliers(const EdgeSearch& search, const Outline& before, const Outline& after) {
  return after.score >= before.score + search.evidence.params.minCornerScore;
}

// A bend wins few, since one line runs near both arms; it must fit much better than the noise
// explains.
bool fitsBetter(const EdgeSearch& search, const Outline& before, const Outline& after) {
  const double squares =
      (after.score - before.score) * maths::square(search.evidence.params.tolerance);
  return squares >= search.evidence.params.minBendRatio * noiseOf(after.lines);
}

// The outline with one edge more, or as it is.
Outline furtherEdge(EdgeSearch& search, const Outline& best) {
  const EdgeEvidence& evidence = search.evidence;
  Outline found = best;
  Outline more =
      withOneMore(search, best, freeFeatures(evidence, best.lines), evidence.params.minCornerScore);
  if (winsInliers(search, best, more)) {
    measure(evidence, more.lines);
    if (isCorner(search, best, more)) found = more;
  }
  for (std::size_t i = 0; i < best.lines.size(); ++i) {
    Outline bend = bent(evidence, best.lines, i);
    if (bend.score <= found.score) continue;
    measure(evidence, bend.lines);
    if (fitsBetter(search, best, bend) && isCorner(search, best, bend)) found = bend;
  }
  return found;
}

// The first edge is the better of two lines with about the same support that has no carpet beyond:
// the carpet is seen up to it, and the other line is the foot of something that stands there.
Outline firstEdge(EdgeSearch& search) {
  const EdgeEvidence& evidence = search.evidence;
  const Outline none{{}, 0.0};
  Outline best = withOneMore(search, none, freeFeatures(evidence, {}), 0.0);
  if (best.lines.empty()) return best;
  const double beyond = carpetBeyond(evidence, best.lines);
  if (beyond <= kBeyondByNoise) return best;
  Outline other = withOneMore(search, none, freeFeatures(evidence, best.lines), 0.0);
  if (other.lines.empty() || carpetBeyond(evidence, other.lines) >= beyond) return best;
  measure(evidence, best.lines);
  measure(evidence, other.lines);
  const auto support = static_cast<double>(best.lines[0].support);
  return static_cast<double>(other.lines[0].support) < kMinSupportShare * support ? best : other;
}

// By exchange: std::sort of so few is a warning, std::stable_sort takes memory.
void strongestFirst(EdgeLines& lines) {
  for (std::size_t i = 0; i < lines.size(); ++i)
    for (std::size_t k = i + 1; k < lines.size(); ++k)
      if (lines[k].support > lines[i].support) std::swap(lines[i], lines[k]);
}

}  // namespace

EdgeLines fitEdgeLines(const EdgeFeatures& features, const HorizonFrame& frame,
                       const FieldEdgeParams& params, VisionCounts& counts) {
  EdgeSearch search{{features, frame, params}, counts, Random(params.seed)};
  double solid = 0.0;
  for (const EdgeFeature& f : features) solid += f.open ? 0.0 : 1.0;
  Outline best = firstEdge(search);
  if (best.lines.empty()) return best.lines;
  while (!best.lines.full()) {
    const Outline more = furtherEdge(search, best);
    if (more.score <= best.score) break;
    best = more;
  }
  measure(search.evidence, best.lines);
  double support = 0.0;
  for (const EdgeLine& line : best.lines) support += static_cast<double>(line.support);
  if (support < params.minSupport || support < params.minShare * solid ||
      !supported(best.lines, 0.0)) {
    refuse(counts, Refusal::edgeFewFeatures);
    return {};
  }
  strongestFirst(best.lines);
  return best.lines;
}

}  // namespace kelpie::vision
