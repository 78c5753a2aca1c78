// SPDX-License-Identifier: Apache-2.0
#include "tools/experiments/harness/Experiment.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace kelpie::experiments {
namespace {

constexpr std::array<const char*, kAllOptions.size()> kOptionNames = {
    "--trials",   "--seed", "--randomise", "--params", "--field", "--traces",
    "--pictures", "--fast", "--minutes",   "--a",      "--b"};

std::string_view name(const Experiment& experiment) { return experiment.name; }

std::string known(const Experiment& experiment) {
  std::string names;
  for (const Option option : kAllOptions)
    if (experiment.uses.has(option)) names += std::string(nameOf(option)) + ", ";
  return names + "--json";
}

}  // namespace

const char* nameOf(Option option) { return kOptionNames[static_cast<std::size_t>(option)]; }

Status checkOptions(const Experiment& experiment, Options given) {
  for (const Option option : kAllOptions)
    if (given.has(option) && !experiment.uses.has(option))
      return Error{std::string(experiment.name) + " does not use " + nameOf(option) +
                   "; it knows " + known(experiment)};
  return Done{};
}

Expected<Json> measure(const Experiment& experiment, const Request& request) {
  const Expected<Json> figures = experiment.run(request);
  if (!figures) return Error{std::string(experiment.name) + ": " + figures.error()};
  Json all{{"experiment", experiment.name}, {"trials", request.trials}, {"seed", request.seed}};
  if (request.randomised.seed != 0) all["randomise"] = request.randomised.seed;
  all.update(*figures);
  return all;
}

const Registration*& Registration::last() {
  static const Registration* last = nullptr;
  return last;
}

std::vector<Experiment> Registration::all() {
  std::vector<Experiment> experiments;
  for (const Registration* one = last(); one != nullptr; one = one->next_)
    experiments.push_back(one->experiment_);
  return experiments;
}

Expected<std::vector<Experiment>> sortedByName(std::vector<Experiment> experiments) {
  std::sort(experiments.begin(), experiments.end(),
            [](const Experiment& a, const Experiment& b) { return name(a) < name(b); });
  const auto twice = std::adjacent_find(
      experiments.begin(), experiments.end(),
      [](const Experiment& a, const Experiment& b) { return name(a) == name(b); });
  if (twice != experiments.end())
    return Error{std::string("two experiments are called '") + twice->name + "'"};
  return experiments;
}

}  // namespace kelpie::experiments
