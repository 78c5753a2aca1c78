// SPDX-License-Identifier: Apache-2.0
// Whether to pass: matches of a team that plays the ball to mates, and stands where it may get it,
// against one that does not and is the same otherwise.
#include "tools/experiments/team/TeamPairs.h"

namespace kelpie::experiments {
namespace {

constexpr TwoSides kSides{Side{"passing", "behaviour.task.passing=true"},
                          Side{"no_passing", "behaviour.task.passing=false"}};

Expected<Json> passing(const Request& request) { return comparePairs(request, kSides); }

const Registration kPassing("passing",
                            "four against four: a team that passes against one that does not",
                            {Option::trials, Option::seed, Option::randomised, Option::params,
                             Option::fast, Option::minutes},
                            20, passing);

}  // namespace
}  // namespace kelpie::experiments
