// SPDX-License-Identifier: Apache-2.0
// The loop over an experiment's trials: each has a number, a seed of its own, and is reported to
// whoever waits.
#pragma once

#include <cstdint>
#include <type_traits>
#include <utility>

#include "tools/experiments/harness/Experiment.h"

namespace kelpie::experiments {

struct Trial {
  int number = 0;          // from 0
  std::uint64_t seed = 1;  // the request's and the number
};

inline Trial trialOf(const Request& request, int number) {
  return {number, request.seed + static_cast<std::uint64_t>(number)};
}

// Calls one(trial) for every trial. Where `one` answers with a Status, so does this: with that of
// the first trial that failed, and no further one is run.
template <class One>
std::invoke_result_t<One, Trial> eachTrial(const Request& request, One&& one) {
  constexpr bool kMayFail = !std::is_void_v<std::invoke_result_t<One, Trial>>;
  for (int i = 0; i < request.trials; ++i) {
    if constexpr (kMayFail) {
      auto done = one(trialOf(request, i));
      if (!done) return done;
    } else {
      one(trialOf(request, i));
    }
    if (request.progress) request.progress(i + 1, request.trials);
  }
  if constexpr (kMayFail) return Done{};
}

}  // namespace kelpie::experiments
