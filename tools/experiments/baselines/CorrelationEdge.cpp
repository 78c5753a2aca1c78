// SPDX-License-Identifier: Apache-2.0
#include "tools/experiments/baselines/CorrelationEdge.h"

#include <algorithm>
#include <cmath>

#include "robot/core/Random.h"

namespace kelpie::baselines {
namespace {

// The first n of the points after mixing them.
vision::EdgeFeatures sample(const vision::EdgeFeatures& points, std::size_t n, Random& random) {
  vision::EdgeFeatures mixed = points;
  for (std::size_t i = 0; i < n; ++i) {
    const auto left = static_cast<std::uint32_t>(points.size() - i);
    std::swap(mixed[i], mixed[i + random.index(left)]);
  }
  mixed.resize(n);
  return mixed;
}

vision::EdgeFeatures near(const vision::EdgeFeatures& points, const SlopeLine& line,
                          double tolerance) {
  vision::EdgeFeatures found;
  for (const vision::EdgeFeature& p : points)
    if (std::fabs(p.at.y - line.offset - line.slope * p.at.x) <= tolerance) found.push_back(p);
  return found;
}

}  // namespace

SlopeLine regression(const vision::EdgeFeatures& points) {
  const auto n = static_cast<double>(points.size());
  double sx = 0.0, sy = 0.0, sxx = 0.0, sxy = 0.0, syy = 0.0;
  for (const vision::EdgeFeature& p : points) {
    sx += p.at.x;
    sy += p.at.y;
    sxx += p.at.x * p.at.x;
    sxy += p.at.x * p.at.y;
    syy += p.at.y * p.at.y;
  }
  const double spread = n * sxx - sx * sx;
  if (!(spread > 0.0)) return {};
  const double slope = (n * sxy - sx * sy) / spread;
  const double height = n * syy - sy * sy;
  const double r = height > 0.0 ? (n * sxy - sx * sy) / std::sqrt(spread * height) : 0.0;
  return {slope, (sy - slope * sx) / n, r};
}

std::optional<SlopeLine> correlationEdge(const vision::EdgeFeatures& points,
                                         const CorrelationParams& params) {
  const auto n = static_cast<std::size_t>(params.points);
  if (points.size() < n) return std::nullopt;
  const bool byCount = params.fitness == EdgeFitness::count;
  Random random(params.seed);
  SlopeLine best;
  double fitness = 0.0;
  for (int round = 0; round < params.rounds; ++round) {
    const SlopeLine tried = regression(sample(points, n, random));
    const vision::EdgeFeatures support = near(points, tried, params.tolerance);
    if (support.size() < static_cast<std::size_t>(params.minSupport)) continue;
    const SlopeLine line = regression(support);
    const double now = byCount ? static_cast<double>(support.size()) : std::fabs(line.r);
    if (now <= fitness) continue;
    fitness = now;
    best = line;
    if (!byCount && fitness > params.stopAboveCorrelation) return best;
  }
  if (fitness <= 0.0 || (!byCount && fitness < params.minCorrelation)) return std::nullopt;
  return best;
}

}  // namespace kelpie::baselines
