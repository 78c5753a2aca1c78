// SPDX-License-Identifier: Apache-2.0
// Where who does not play the ball stands: by the trees of thesis 2006 section 4.5.2 or by
// regression over examples (section 4.5.3). Matches of two teams that differ in that alone.
#include "tools/experiments/team/TeamPairs.h"

namespace kelpie::experiments {
namespace {

constexpr TwoSides kSides{Side{"tree", "behaviour.task.positions=0"},
                          Side{"regression", "behaviour.task.positions=1"}};

Expected<Json> positions(const Request& request) { return comparePairs(request, kSides); }

const Registration kPositions("positions",
                              "four against four: positions by tree against those by regression",
                              {Option::trials, Option::seed, Option::randomised, Option::params,
                               Option::fast, Option::minutes},
                              20, positions);

}  // namespace
}  // namespace kelpie::experiments
