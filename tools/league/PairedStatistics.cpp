// SPDX-License-Identifier: Apache-2.0
#include "tools/league/PairedStatistics.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "robot/core/Random.h"
#include "tools/cli/Figures.h"
#include "tools/league/StudentT.h"

namespace kelpie::league {
namespace {

double sumOf(const Differences& differences) {
  return std::accumulate(differences.begin(), differences.end(), 0.0);
}

double countOf(const Differences& differences) { return static_cast<double>(differences.size()); }

Differences withoutZeros(const Differences& differences) {
  Differences rest;
  std::copy_if(differences.begin(), differences.end(), std::back_inserter(rest),
               [](double d) { return d != 0.0; });
  return rest;
}

// How many sums are as large as the observed one, and how many as far from 0. Sums that differ by
// rounding alone are the same.
struct FlipCount {
  double observed;
  double tolerance;
  std::uint64_t above = 0;
  std::uint64_t farther = 0;

  explicit FlipCount(const Differences& differences) : observed(sumOf(differences)) {
    double size = 0.0;
    for (const double d : differences) size += std::fabs(d);
    tolerance = 1e-10 * size;
  }
  void add(double sum) {
    above += sum >= observed - tolerance ? 1U : 0U;
    farther += std::fabs(sum) >= std::fabs(observed) - tolerance ? 1U : 0U;
  }
  Probability of(double ways) const {
    return {static_cast<double>(above) / ways, static_cast<double>(farther) / ways};
  }
};

// By Gray code: each way differs from the one before in one sign.
SignFlip flipAll(Differences differences) {
  FlipCount count(differences);
  double sum = count.observed;
  const std::uint64_t ways = std::uint64_t{1} << differences.size();
  for (std::uint64_t way = 1; way <= ways; ++way) {
    count.add(sum);
    if (way == ways) break;
    std::size_t flipped = 0;
    while ((way >> flipped & 1U) == 0) ++flipped;
    sum -= 2.0 * differences[flipped];
    differences[flipped] = -differences[flipped];
  }
  return {count.of(static_cast<double>(ways)), true};
}

double flippedSum(const Differences& differences, Random& random) {
  double sum = 0.0;
  std::uint64_t signs = 0;
  for (std::size_t i = 0; i < differences.size(); ++i) {
    if (i % 64 == 0) signs = random.next();
    sum += (signs >> i % 64 & 1U) != 0 ? differences[i] : -differences[i];
  }
  return sum;
}

SignFlip flipSome(const Differences& differences, const Resampling& params) {
  FlipCount count(differences);
  Random random(params.seed);
  count.add(count.observed);
  for (int i = 0; i < params.flips; ++i) count.add(flippedSum(differences, random));
  return {count.of(params.flips + 1.0), false};
}

// Which share of the resampled means is outside on either side: that of the normal distribution
// beyond sqrt(n / (n - 1)) t, since resampled means vary by less than S / sqrt(n), and S is unsure.
double shareOutside(std::uint32_t count, double confidence) {
  if (count < 2) return 0.0;
  const double n = count;
  const double t = studentQuantile(0.5 * (1.0 - confidence), static_cast<int>(count) - 1);
  return 0.5 * std::erfc(std::sqrt(n / (n - 1.0)) * t / std::sqrt(2.0));
}

}  // namespace

double meanOf(const Differences& differences) {
  return differences.empty() ? 0.0 : sumOf(differences) / countOf(differences);
}

double spreadOf(const Differences& differences) {
  const auto [min, max] = std::minmax_element(differences.begin(), differences.end());
  // Equal ones have none; their mean may be off by its rounding.
  if (differences.size() < 2 || *min == *max) return 0.0;
  const double mean = meanOf(differences);
  double squares = 0.0;
  for (const double d : differences) squares += (d - mean) * (d - mean);
  return std::sqrt(squares / (countOf(differences) - 1.0));
}

std::optional<TTest> tTest(const Differences& differences) {
  const double spread = spreadOf(differences);
  if (!(spread > 0.0)) return std::nullopt;
  const double t = std::sqrt(countOf(differences)) * meanOf(differences) / spread;
  const int freedom = static_cast<int>(differences.size()) - 1;
  return TTest{t, {studentTail(t, freedom), 2.0 * studentTail(std::fabs(t), freedom)}};
}

std::optional<Interval> studentInterval(const Differences& differences, double confidence) {
  const double spread = spreadOf(differences);
  if (!(spread > 0.0)) return std::nullopt;
  const int freedom = static_cast<int>(differences.size()) - 1;
  const double half =
      studentQuantile(0.5 * (1.0 - confidence), freedom) * spread / std::sqrt(countOf(differences));
  return Interval{meanOf(differences) - half, meanOf(differences) + half};
}

SignFlip signFlip(const Differences& differences, const Resampling& params) {
  const Differences signedOnes = withoutZeros(differences);
  return signedOnes.size() <= kExactFlips ? flipAll(signedOnes) : flipSome(signedOnes, params);
}

Interval bootstrap(const Differences& differences, const Resampling& params) {
  if (differences.empty()) return {};
  Random random(params.seed);
  const auto count = static_cast<std::uint32_t>(differences.size());
  std::vector<double> means(static_cast<std::size_t>(std::max(1, params.resamples)));
  for (double& mean : means) {
    for (std::uint32_t i = 0; i < count; ++i) mean += differences[random.index(count)];
    mean /= count;
  }
  std::sort(means.begin(), means.end());
  const double outside = shareOutside(count, params.confidence);
  return {cli::percentile(means, outside), cli::percentile(means, 1.0 - outside)};
}

PairedStatistics statisticsOf(const Differences& differences, const Resampling& params) {
  PairedStatistics statistics;
  statistics.count = differences.size();
  statistics.mean = meanOf(differences);
  statistics.spread = spreadOf(differences);
  statistics.t = tTest(differences);
  statistics.student = studentInterval(differences, params.confidence);
  statistics.signFlip = signFlip(differences, params);
  statistics.bootstrap = bootstrap(differences, params);
  return statistics;
}

}  // namespace kelpie::league
