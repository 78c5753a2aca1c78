// SPDX-License-Identifier: Apache-2.0
// `kelpie calibrate kicks`: measures each kick from many places of the ball and writes the module
// that the behaviours choose kicks by.
#include <fmt/core.h>

#include <memory>

#include "tools/cli/Commands.h"
#include "tools/cli/Process.h"
#include "tools/cli/Progress.h"
#include "tools/cli/WholeFile.h"
#include "tools/cli/calibrate/Calibrate.h"
#include "tools/cli/options/Usage.h"
#include "tools/learn/kick/KickMapFile.h"

namespace kelpie::cli {
namespace {

constexpr const char* kHelp =
    R"(
Plays each kick on varied physical models with the ball at each place of a grid, and held, and
writes what became of the ball as a Python module. A place's runs lie up to half a step beside it.
Models and places are drawn from the seed; `kelpie evaluate kick-map` says how right the map is on
others. Takes minutes; an interrupt ends it and leaves the file as it was.
docs/physical-body.md, "The kick map".

  kelpie calibrate kicks --out pycode/data/kick_map.py
  kelpie calibrate kicks --trials 2 --step 4 --out -)";

struct KicksOptions {
  std::string out;
  learn::KickMapPlan plan;
};

void describe(const learn::KickGrid& grid) {
  const learn::KickCell& whole = grid.window.whole;
  const std::string name = actuator::kMotionNames[static_cast<std::size_t>(grid.motion)];
  const std::string where =
      grid.from == learn::KickFrom::hold
          ? ""
          : fmt::format("{:.0f} {:.0f}", grid.window.best.x, grid.window.best.y);
  fmt::print(
      stderr, "{:8} {:16} {:>5}: {:3.0f} % go, {:4.0f} deg (sd {:2.0f}), {:3.0f} cm (sd {:2.0f})\n",
      learn::kKickFromNames[static_cast<std::size_t>(grid.from)], name, where, 100.0 * whole.went,
      whole.direction.deg(), whole.directionSd.deg(), whole.distance, whole.distanceSd);
}

int calibrateKicks(const KicksOptions& options) {
  if (!canWrite(options.out)) return fail(options.out + ": cannot be written", kExitBadInput);
  catchInterrupts();
  Progress progress("kick map", "kicks");
  const learn::KickMap map =
      learn::learnKickMap(options.plan, [&](std::size_t done, std::size_t all) {
        progress(done, all);
        return !interrupted();
      });
  if (map.empty()) return fail("interrupted; nothing is written", kExitInterrupted);
  for (const learn::KickGrid& grid : map) describe(grid);
  const std::uint64_t first = learn::firstModelOf(options.plan);
  const std::string about = fmt::format(
      "kelpie calibrate kicks --trials {} --seed {} --step {}\n"
      "models of the seeds {} to {}, one run on each at each place, {} from the hold",
      options.plan.trials, options.plan.seed, options.plan.step, first,
      first + static_cast<std::uint64_t>(options.plan.trials) - 1, map.back().window.whole.runs);
  if (!writeWhole(options.out, learn::kickMapText(map, about)))
    return fail(options.out + ": cannot be written", kExitBadInput);
  return kExitDone;
}

}  // namespace

void addCalibrateKicks(CommandLine& command, int& code) {
  auto kicks = command.subcommand("kicks", "Measure where each kick sends the ball, from where");
  kicks.footer(kHelp);
  auto options = std::make_shared<KicksOptions>();
  kicks.option("--out", options->out, "Python module to write").required();
  kicks.option("--trials", options->plan.trials, "at each place, each on another varied model")
      .check(inRange(1, 1000))
      .showDefault();
  kicks.option("--seed", options->plan.seed, "of models and places")
      .check(inRange(0, 1e6))
      .showDefault();
  kicks.option("--step", options->plan.step, "cm between two places")
      .check(inRange(1, 8))
      .showDefault();
  kicks.callback([options, &code] { code = calibrateKicks(*options); });
}

}  // namespace kelpie::cli
