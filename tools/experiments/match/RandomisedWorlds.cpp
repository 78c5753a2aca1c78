// SPDX-License-Identifier: Apache-2.0
// What holds where Kelpie was tuned beside what holds elsewhere: objects, localise, kidnap and
// score-empty-goal as they are, in the nominal world and in as many randomised ones as there are
// trials.
#include <array>

#include "tools/experiments/harness/Experiment.h"

namespace kelpie::experiments {
namespace {

struct Part {
  const char* name;
  int perTrial;  // its own trials for one of ours
};
// Views are drawn in worlds of 25: six worlds a trial, as many views as the experiment has itself.
constexpr std::array<Part, 4> kParts{
    {{"objects", 150}, {"localise", 1}, {"kidnap", 1}, {"score-empty-goal", 1}}};

Expected<Json> figuresOf(const Part& part, Request request) {
  request.trials *= part.perTrial;
  for (const Experiment& one : Registration::all())
    if (std::string(one.name) == part.name) return measure(one, request);
  return Error{std::string("there is no experiment ") + part.name};
}

// The plain numbers only: bands and single trials are the parts' own affair.
void addNumbers(const std::string& prefix, const Json& figures, Json& to) {
  for (const auto& [key, value] : figures.items())
    if (value.is_number() && key != "trials" && key != "seed" && key != "randomise")
      to[prefix + key] = value;
}

Expected<Json> randomised(const Request& request) {
  Request like = request;
  like.randomised = {};
  Request other = request;
  if (other.randomised.seed == 0) other.randomised.seed = request.seed;
  Json all;
  for (const Part& part : kParts) {
    const Expected<Json> before = figuresOf(part, like);
    if (!before) return before;
    const Expected<Json> after = figuresOf(part, other);
    if (!after) return after;
    Json& both = all[part.name];
    addNumbers("", *before, both);
    addNumbers("randomised_", *after, both);
  }
  return all;
}

const Registration kRandomised(
    "randomised", "objects, localise, kidnap, a goal: randomised worlds beside the nominal",
    {Option::trials, Option::seed, Option::randomised}, 40, randomised);

}  // namespace
}  // namespace kelpie::experiments
