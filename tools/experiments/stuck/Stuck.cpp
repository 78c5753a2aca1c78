// SPDX-License-Identifier: Apache-2.0
// Being stuck: what the legs tell of it, what the localiser makes of that (thesis 2004 section
// 2.2.4, figure 2.10), and how soon the pose is right again after a scrum
// (thesis 2004 section 5.1).
#include "tools/experiments/stuck/StuckScrums.h"
#include "tools/experiments/stuck/StuckWalks.h"

namespace kelpie::experiments {
namespace {

Expected<Json> stuck(const Request& request) {
  const auto afterScrums = scrums(request);
  if (!afterScrums) return Error{afterScrums.error()};
  return Json{{"walks", heldWalks(request)},
              {"effort", effortCalibration(request)},
              {"weak_legs", weakTurns(request)},
              {"scrums", *afterScrums}};
}

const Registration kStuck("stuck",
                          "held while walking, weak legs, scrums: what is noticed and believed",
                          {Option::trials, Option::seed, Option::randomised, Option::params}, 8,
                          stuck);

}  // namespace
}  // namespace kelpie::experiments
