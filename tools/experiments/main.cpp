// SPDX-License-Identifier: Apache-2.0
// kelpie-experiments: what `kelpie evaluate` runs. A program of its own, since the experiments take
// longer to compile than everything that a match needs.
#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <exception>

#include "tools/cli/Process.h"
#include "tools/cli/Terminal.h"
#include "tools/cli/Usage.h"
#include "tools/cli/WholeFile.h"
#include "tools/experiments/Experiment.h"

namespace kelpie::experiments {
namespace {

struct EvaluateOptions {
  std::string name;
  int trials = 0;
  std::uint64_t seed = 1;
  std::string json = "-";
  std::string pictures;
  std::vector<std::string> params;
  bool list = false;
};

int listExperiments() {
  for (const auto& experiment : experiments())
    fmt::print("{:20} {} (trials: {})\n", experiment.name, experiment.measures, experiment.trials);
  return cli::kDone;
}

int evaluate(const EvaluateOptions& options) {
  if (options.list) return listExperiments();
  const auto& all = experiments();
  const auto found = std::find_if(all.begin(), all.end(),
                                  [&](const Experiment& e) { return e.name == options.name; });
  if (found == all.end())
    return cli::complain(options.name.empty()
                             ? "name an experiment; `kelpie evaluate --list` tells which there are"
                             : "no experiment '" + options.name +
                                   "'; `kelpie evaluate --list` tells which there are",
                         cli::kBadInput);
  if (!cli::canWrite(options.json))
    return cli::complain(options.json + ": cannot be written", cli::kBadInput);
  ExperimentOptions request;
  request.trials = options.trials > 0 ? options.trials : found->trials;
  request.seed = options.seed;
  request.pictures = options.pictures;
  request.params = options.params;
  if (cli::onTerminal())
    request.progress = [](int done, int count) {
      fmt::print(stderr, "\r{} of {}{}", done, count, done == count ? "\n" : "");
    };
  const auto figures = found->run(request);
  if (!figures) return cli::complain(options.name + ": " + figures.error(), cli::kCheckFailed);
  if (!cli::writeWhole(options.json, figures->dump(2) + "\n"))
    return cli::complain(options.json + ": cannot be written", cli::kBadInput);
  return cli::kDone;
}

void addOptions(CLI::App& app, EvaluateOptions& options) {
  app.add_option("NAME", options.name, "The experiment (--list tells which there are)");
  app.add_option("--trials", options.trials, "How often (default: the experiment's own)")
      ->check(CLI::Range(1, 1000000));
  app.add_option("--seed", options.seed, "Seed of the first trial")
      ->check(cli::inRange(0.0, cli::kLargestSeed))
      ->capture_default_str();
  app.add_option("--json", options.json, "File for the figures, - for standard output");
  app.add_option("--pictures", options.pictures,
                 "Folder for pictures of what went wrong (experiment `objects`) or a table of "
                 "every frame (`localise`, `kidnap`, `slam`)")
      ->check(CLI::ExistingDirectory);
  app.add_option("--params", options.params,
                 "The agent's TOML files (experiments `localise`, `kidnap`, `slam`)")
      ->check(CLI::ExistingFile);
  app.add_flag("--list", options.list, "What each experiment measures");
}

}  // namespace
}  // namespace kelpie::experiments

int main(int argc, char** argv) {
  using namespace kelpie;
  cli::useTargetMaths(argv);
  CLI::App app{"Measure: one JSON object of plain figures", "kelpie evaluate"};
  experiments::EvaluateOptions options;
  experiments::addOptions(app, options);
  bool done = false;
  const int usage = cli::parseOptions(app, argc, argv, done);
  if (done) return usage;
  try {
    return experiments::evaluate(options);
  } catch (const std::exception& error) {
    return cli::complain(error.what(), cli::kBadInput);
  }
}
