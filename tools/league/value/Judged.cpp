// SPDX-License-Identifier: Apache-2.0
#include "tools/league/value/Judged.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace kelpie::value {
namespace {

constexpr double kSurest = 1e-9;  // a probability that is not 0, so that its logarithm is finite

double lossOf(double p, bool was) {
  const double sure = maths::clamp(p, kSurest, 1.0 - kSurest);
  return -maths::log(was ? sure : 1.0 - sure);
}

double meanOf(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

Bin binOf(const std::vector<Said>& said, std::size_t from, std::size_t to) {
  Bin bin;
  for (std::size_t i = from; i < to; ++i) {
    bin.said += said[i].p;
    bin.was += said[i].was ? 1.0 : 0.0;
  }
  const auto all = static_cast<double>(to - from);
  return {bin.said / all, bin.was / all};
}

}  // namespace

std::vector<Said> saidOf(const std::vector<Row>& rows, const Model& model) {
  std::vector<Said> said;
  for (const Row& row : rows) {
    const bool soon = row.left <= model.horizon;
    if (soon && row.ends == 0) continue;
    said.push_back({valueOf(model, row.features), soon && row.ends > 0});
  }
  return said;
}

double sharedBy(const std::vector<Said>& said) {
  if (said.empty()) return 0.0;
  const auto hits = std::count_if(said.begin(), said.end(), [](const Said& s) { return s.was; });
  return static_cast<double>(hits) / static_cast<double>(said.size());
}

double logLoss(const std::vector<Said>& said) {
  if (said.empty()) return 0.0;
  double loss = 0.0;
  for (const Said& each : said) loss += lossOf(each.p, each.was);
  return loss / static_cast<double>(said.size());
}

double baseLogLoss(const std::vector<Said>& said) {
  const double share = sharedBy(said);
  return share * lossOf(share, true) + (1.0 - share) * lossOf(share, false);
}

std::vector<Bin> binsOf(std::vector<Said> said, std::size_t bins) {
  std::stable_sort(said.begin(), said.end(),
                   [](const Said& a, const Said& b) { return a.p < b.p; });
  std::vector<Bin> found;
  for (std::size_t i = 0; i < bins; ++i) {
    const std::size_t from = i * said.size() / bins, to = (i + 1) * said.size() / bins;
    if (from < to) found.push_back(binOf(said, from, to));
  }
  return found;
}

double calibrationError(const std::vector<Bin>& bins) {
  double gaps = 0.0;
  for (const Bin& bin : bins) gaps += std::fabs(bin.said - bin.was);
  return bins.empty() ? 0.0 : gaps / static_cast<double>(bins.size());
}

double correlation(const std::vector<double>& a, const std::vector<double>& b) {
  if (a.empty() || a.size() != b.size()) return 0.0;
  const double meanA = meanOf(a), meanB = meanOf(b);
  double both = 0.0, ofA = 0.0, ofB = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    both += (a[i] - meanA) * (b[i] - meanB);
    ofA += maths::square(a[i] - meanA);
    ofB += maths::square(b[i] - meanB);
  }
  return ofA > 0.0 && ofB > 0.0 ? both / std::sqrt(ofA * ofB) : 0.0;
}

}  // namespace kelpie::value
