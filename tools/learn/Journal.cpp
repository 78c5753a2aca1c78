// SPDX-License-Identifier: Apache-2.0
#include "tools/learn/Journal.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <sstream>

namespace kelpie::learn {
namespace {

std::string headOf(const SearchSpace& space, const SearchPlan& plan) {
  std::string text =
      fmt::format("cma seed {} population {} spread {}", plan.seed, plan.population, plan.spread);
  for (std::size_t i = 0; i < space.names.size(); ++i)
    text += fmt::format(" {} {:a} {:a} {:a}", space.names[i], space.least[i], space.most[i],
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

Status Journal::open(const SearchSpace& space, const SearchPlan& plan) {
  if (plan.journal.empty()) return Done{};
  const std::string head = headOf(space, plan);
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

const double* Journal::find(std::size_t i, const std::vector<double>& point) const {
  if (i >= known_.size()) return nullptr;
  return std::equal(point.begin(), point.end(), known_[i].begin()) ? &known_[i].back() : nullptr;
}

void Journal::add(const std::vector<double>& point, double gain) {
  if (out_.is_open()) out_ << lineOf(point, gain) << std::flush;
}

Status Journal::rewrite(const std::string& head, const std::string& path) {
  out_.open(path, std::ios::trunc);
  out_ << head << '\n';
  for (const auto& numbers : known_)
    out_ << lineOf({numbers.begin(), numbers.end() - 1}, numbers.back());
  out_.flush();
  if (!out_) return Error{path + ": cannot be written"};
  return Done{};
}

}  // namespace kelpie::learn
