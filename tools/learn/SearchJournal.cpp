// SPDX-License-Identifier: Apache-2.0
#include "tools/learn/SearchJournal.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <sstream>

namespace kelpie::learn {
namespace {

std::string headOf(const SearchSpace& space, const SearchPlan& plan) {
  std::string text =
      fmt::format("cma seed {} population {} spread {}", plan.seed, plan.population, plan.spread);
  if (!plan.trial.empty()) text += " " + plan.trial;
  for (std::size_t i = 0; i < space.names.size(); ++i)
    text += fmt::format(" {} {:a} {:a} {:a}", space.names[i], space.min[i], space.max[i],
                        space.start[i]);
  return text;
}

std::vector<double> numbersOf(const std::string& line) {
  std::vector<double> numbers;
  std::istringstream words(line);
  for (std::string word; words >> word;) numbers.push_back(std::strtod(word.c_str(), nullptr));
  return numbers;
}

std::string lineOf(const std::vector<double>& point, double gain) {
  std::string text;
  for (const double number : point) text += fmt::format("{:a} ", number);
  return text + fmt::format("{:a}\n", gain);
}

}  // namespace

Status SearchJournal::open(const SearchSpace& space, const SearchPlan& plan) {
  if (plan.journal.empty()) return Done{};
  std::error_code error;
  if (std::filesystem::exists(plan.journal, error) &&
      !std::filesystem::is_regular_file(plan.journal, error))
    return Error{plan.journal + ": is no file"};
  path_ = plan.journal;
  head_ = headOf(space, plan);
  std::ifstream file(plan.journal);
  std::string line;
  if (file && std::getline(file, line) && line != head_)
    return Error{plan.journal + ": is the journal of another search"};
  while (std::getline(file, line)) {
    std::vector<double> numbers = numbersOf(line);
    // The last one may be cut off while it was written, in the middle of a number, too.
    if (file.eof() || numbers.size() != space.names.size() + 1) break;
    known_.push_back(std::move(numbers));
  }
  return rewrite();
}

const double* SearchJournal::find(std::size_t i, const std::vector<double>& point) const {
  if (i >= known_.size()) return nullptr;
  return std::equal(point.begin(), point.end(), known_[i].begin()) ? &known_[i].back() : nullptr;
}

Status SearchJournal::add(std::size_t i, const std::vector<double>& point, double gain) {
  if (path_.empty()) return Done{};
  if (i < known_.size()) {
    known_.resize(i);
    const Status cut = rewrite();
    if (!cut) return cut;
  }
  known_.push_back(point);
  known_.back().push_back(gain);
  out_ << lineOf(point, gain) << std::flush;
  if (!out_) return Error{path_ + ": cannot be written"};
  return Done{};
}

// In another file first: a journal that is there already is never lost.
Status SearchJournal::rewrite() {
  const std::string part = path_ + ".part";
  out_ = std::ofstream(part, std::ios::trunc);
  out_ << head_ << '\n';
  for (const auto& numbers : known_)
    out_ << lineOf({numbers.begin(), numbers.end() - 1}, numbers.back());
  out_.flush();
  if (out_ && std::rename(part.c_str(), path_.c_str()) == 0) return Done{};
  std::remove(part.c_str());
  return Error{path_ + ": cannot be written"};
}

}  // namespace kelpie::learn
