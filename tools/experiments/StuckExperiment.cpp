// SPDX-License-Identifier: Apache-2.0
// Being stuck: what the legs tell of it, what the localiser makes of that (thesis 2004 section
// 2.2.4, figure 2.10), and how soon the pose is right again after a scrum
// (thesis 2004 section 5.1).
#include "tools/experiments/StuckScrums.h"
#include "tools/experiments/StuckWalks.h"

namespace kelpie::experiments {

Expected<Json> stuck(const ExperimentOptions& options) {
  const auto after = scrums(options);
  if (!after) return Error{after.error()};
  return Json{{"experiment", "stuck"},
              {"trials", options.trials},
              {"seed", options.seed},
              {"walks", heldWalks(options)},
              {"effort", effortCalibration(options)},
              {"weak_legs", weakTurns(options)},
              {"scrums", *after}};
}

}  // namespace kelpie::experiments
