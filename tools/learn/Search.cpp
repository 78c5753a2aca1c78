// SPDX-License-Identifier: Apache-2.0
#include "tools/learn/Search.h"

#include <fmt/format.h>
#include <nlopt.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <memory>
#include <sstream>

namespace kelpie::learn {
namespace {

// The trials of one search. A line of the file: the point's numbers, then its gain.
class Journal {
 public:
  Status open(const SearchSpace& space, const SearchPlan& plan) {
    if (plan.journal.empty()) return Done{};
    const std::string head = header(space, plan);
    std::ifstream file(plan.journal);
    std::string line;
    if (file && std::getline(file, line) && line != head)
      return Error{plan.journal + ": is the journal of another search"};
    while (std::getline(file, line)) {
      std::vector<double> numbers = numbersOf(line);
      if (numbers.size() != space.names.size() + 1) break;  // cut off while it was written
      known_.push_back(std::move(numbers));
    }
    return rewrite(head, plan.journal);
  }
  // The gain of trial number i, when it is known and was of that point.
  const double* find(std::size_t i, const std::vector<double>& point) const {
    if (i >= known_.size()) return nullptr;
    return std::equal(point.begin(), point.end(), known_[i].begin()) ? &known_[i].back() : nullptr;
  }
  void add(const std::vector<double>& point, double gain) {
    if (out_.is_open()) out_ << lineOf(point, gain) << std::flush;
  }

 private:
  static std::string header(const SearchSpace& space, const SearchPlan& plan) {
    std::string text = fmt::format("seed {} population {}", plan.seed, plan.population);
    for (std::size_t i = 0; i < space.names.size(); ++i)
      text += fmt::format(" {} {:a} {:a} {:a}", space.names[i], space.least[i], space.most[i],
                          space.start[i]);
    return text;
  }
  static std::vector<double> numbersOf(const std::string& line) {
    std::vector<double> numbers;
    std::istringstream words(line);
    for (std::string word; words >> word;) numbers.push_back(std::strtod(word.c_str(), nullptr));
    return numbers;
  }
  static std::string lineOf(const std::vector<double>& point, double gain) {
    std::string text;
    for (const double number : point) text += fmt::format("{:a} ", number);
    return text + fmt::format("{:a}\n", gain);
  }
  Status rewrite(const std::string& head, const std::string& path) {
    out_.open(path, std::ios::trunc);
    out_ << head << '\n';
    for (const auto& numbers : known_)
      out_ << lineOf({numbers.begin(), numbers.end() - 1}, numbers.back());
    out_.flush();
    if (!out_) return Error{path + ": cannot be written"};
    return Done{};
  }

  std::vector<std::vector<double>> known_;
  std::ofstream out_;
};

struct Run {
  const Gain& gain;
  const Told& told;
  Journal journal;
  SearchResult result;
};

double cost(unsigned count, const double* x, double*, void* data) {
  Run& run = *static_cast<Run*>(data);
  const std::vector<double> point(x, x + count);
  const double* known = run.journal.find(run.result.gains.size(), point);
  const double gain = known != nullptr ? *known : run.gain(point);
  run.result.replayed += known != nullptr ? 1 : 0;
  run.journal.add(point, gain);
  if (run.result.gains.empty() || gain > run.result.gain) {
    run.result.gain = gain;
    run.result.best = point;
  }
  run.result.gains.push_back(run.result.gain);
  run.told(static_cast<int>(run.result.gains.size()), run.result.gain);
  return -gain;
}

}  // namespace

Expected<SearchResult> search(const SearchSpace& space, const SearchPlan& plan, const Gain& gain,
                              const Told& told) {
  Run run{gain, told, {}, {}};
  const Status opened = run.journal.open(space, plan);
  if (!opened) return Error{opened.error()};
  const std::unique_ptr<nlopt_opt_s, void (*)(nlopt_opt)> optimiser(
      nlopt_create(NLOPT_GN_CRS2_LM, static_cast<unsigned>(space.names.size())), nlopt_destroy);
  nlopt_srand(plan.seed);
  nlopt_set_min_objective(optimiser.get(), cost, &run);
  nlopt_set_lower_bounds(optimiser.get(), space.least.data());
  nlopt_set_upper_bounds(optimiser.get(), space.most.data());
  nlopt_set_population(optimiser.get(), static_cast<unsigned>(plan.population));
  nlopt_set_maxeval(optimiser.get(), plan.trials);
  std::vector<double> x = space.start;
  for (std::size_t i = 0; i < x.size(); ++i) x[i] = std::clamp(x[i], space.least[i], space.most[i]);
  double least = 0.0;
  nlopt_optimize(optimiser.get(), x.data(), &least);
  return run.result;
}

}  // namespace kelpie::learn
