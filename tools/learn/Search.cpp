// SPDX-License-Identifier: Apache-2.0
#include "tools/learn/Search.h"

#include <algorithm>

#include "tools/learn/Cma.h"
#include "tools/learn/SearchJournal.h"

namespace kelpie::learn {
namespace {

struct Run {
  const Gain& gain;
  const Listener& listener;
  SearchJournal journal;
  SearchResult result;
  Status written = Done{};

  double tryPoint(const std::vector<double>& point) {
    const double* known = journal.find(result.gains.size(), point);
    const double now = known != nullptr ? *known : gain(point);
    if (known != nullptr)
      ++result.replayed;
    else if (written)
      written = journal.add(result.gains.size(), point, now);
    if (result.gains.empty() || now > result.gain) {
      result.gain = now;
      result.best = point;
    }
    result.gains.push_back(result.gain);
    listener(static_cast<int>(result.gains.size()), result.gain);
    return now;
  }
};

// In shares of the way from the least to the most of each number.
std::vector<double> scaled(const std::vector<double>& shares, const SearchSpace& space) {
  std::vector<double> point = shares;
  for (std::size_t i = 0; i < point.size(); ++i)
    point[i] = space.min[i] + shares[i] * (space.max[i] - space.min[i]);
  return point;
}

std::vector<double> sharesOf(const std::vector<double>& point, const SearchSpace& space) {
  std::vector<double> shares = point;
  for (std::size_t i = 0; i < point.size(); ++i) {
    const double whole = space.max[i] - space.min[i];
    shares[i] = whole > 0.0 ? (point[i] - space.min[i]) / whole : 0.5;
  }
  return shares;
}

Status searchFrom(const SearchSpace& space, const SearchPlan& plan,
                  const std::vector<double>& start, Run& run) {
  auto cma = Cma::start(sharesOf(start, space), plan);
  if (!cma) return Error{cma.error()};
  run.tryPoint(start);
  while (run.written && run.result.gains.size() < static_cast<std::size_t>(plan.trials)) {
    const auto asked = cma->ask();
    if (!asked) return Error{asked.error()};
    std::vector<double> gains;
    const std::size_t left = static_cast<std::size_t>(plan.trials) - run.result.gains.size();
    for (std::size_t i = 0; i < std::min(left, asked->size()) && run.written; ++i)
      gains.push_back(run.tryPoint(scaled((*asked)[i], space)));
    if (gains.size() == asked->size()) cma->tell(gains);
  }
  return run.written;
}

}  // namespace

Expected<SearchResult> search(const SearchSpace& space, const SearchPlan& plan, const Gain& gain,
                              const Listener& listener) {
  Run run{gain, listener, {}, {}, Done{}};
  const Status opened = run.journal.open(space, plan);
  if (!opened) return Error{opened.error()};
  std::vector<double> start = space.start;
  for (std::size_t i = 0; i < start.size(); ++i)
    start[i] = std::clamp(start[i], space.min[i], space.max[i]);
  const Status searched = searchFrom(space, plan, start, run);
  if (!searched) return Error{searched.error()};
  return run.result;
}

}  // namespace kelpie::learn
