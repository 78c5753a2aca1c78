// SPDX-License-Identifier: Apache-2.0
// Whether the camera loop keeps up (checklist M01): the share of frames that are processed before
// the next image comes, over minutes of play on this machine. A wall clock measures the machine as
// much as the code: a figure of one's own PC, never a test. On the robot instructions are counted
// instead (toolchain/target-cost).
#include "tools/cli/options/Config.h"
#include "tools/experiments/harness/Statistics.h"
#include "tools/experiments/harness/Trials.h"
#include "tools/experiments/pose/LocaliseMatch.h"

namespace kelpie::experiments {
namespace {

constexpr double kMinutes = 10.0;  // of play, a trial

Status playMatch(const Request& request, const agent::AgentConfig& config, const Trial& trial,
                 Values& milliseconds) {
  LocaliseMatch match(config, cli::defaultScripts(), trial.seed, request.randomised, !request.fast);
  const auto watch = [&](const WatchedFrame& frame) {
    milliseconds.push_back(1000.0 * frame.seconds);
  };
  for (int minute = 1; minute <= static_cast<int>(kMinutes); ++minute) {
    const Status played = match.play(60.0 * minute, watch);
    if (!played) return played;
    if (request.progress && request.trials == 1)
      request.progress(minute, static_cast<int>(kMinutes));
  }
  return Done{};
}

Expected<Json> loop(const Request& request) {
  const auto config = agentConfig(request, !request.fast);
  if (!config) return Error{config.error()};
  Values milliseconds;
  const Status played = eachTrial(request, [&](const Trial& trial) {
    return playMatch(request, *config, trial, milliseconds);
  });
  if (!played) return Error{played.error()};
  return Json{{"frames", milliseconds.size()},
              {"in_time_share", shareUpTo(milliseconds, 1000.0 * kFrameSeconds)},
              {"median_ms", percentile(milliseconds, 0.5)},
              {"p99_ms", percentile(milliseconds, 0.99)},
              {"longest_ms", percentile(milliseconds, 1.0)}};
}

const Registration kLoop(
    "loop", "ten minutes of play: share of frames done within 33.3 ms on this machine",
    {Option::trials, Option::seed, Option::randomised, Option::params, Option::fast}, 1, loop);

}  // namespace
}  // namespace kelpie::experiments
