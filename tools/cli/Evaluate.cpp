// SPDX-License-Identifier: Apache-2.0
#include <fmt/core.h>

#include <algorithm>
#include <memory>

#include "tools/cli/Commands.h"
#include "tools/cli/Config.h"
#include "tools/cli/experiments/Experiment.h"

namespace kelpie::cli {
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
  return kDone;
}

int evaluate(const EvaluateOptions& options) {
  if (options.list) return listExperiments();
  const auto& all = experiments();
  const auto found = std::find_if(all.begin(), all.end(),
                                  [&](const Experiment& e) { return e.name == options.name; });
  if (found == all.end())
    return complain(options.name.empty()
                        ? "name an experiment; `kelpie evaluate --list` tells which there are"
                        : "no experiment '" + options.name +
                              "'; `kelpie evaluate --list` tells which there are",
                    kBadInput);
  if (!canWrite(options.json)) return complain(options.json + ": cannot be written", kBadInput);
  ExperimentOptions request;
  request.trials = options.trials > 0 ? options.trials : found->trials;
  request.seed = options.seed;
  request.pictures = options.pictures;
  request.params = options.params;
  if (onTerminal())
    request.progress = [](int done, int count) {
      fmt::print(stderr, "\r{} of {}{}", done, count, done == count ? "\n" : "");
    };
  const auto figures = found->run(request);
  if (!figures) return complain(options.name + ": " + figures.error(), kCheckFailed);
  if (!writeWhole(options.json, figures->dump(2) + "\n"))
    return complain(options.json + ": cannot be written", kBadInput);
  return kDone;
}

}  // namespace

void addEvaluate(CLI::App& app, int& code) {
  auto* command = app.add_subcommand("evaluate", "Measure: one JSON object of plain figures");
  auto options = std::make_shared<EvaluateOptions>();
  command->add_option("NAME", options->name, "The experiment (--list tells which there are)");
  command->add_option("--trials", options->trials, "How often (default: the experiment's own)")
      ->check(CLI::Range(1, 1000000));
  command->add_option("--seed", options->seed, "Seed of the first trial")
      ->check(inRange(0.0, kLargestSeed))
      ->capture_default_str();
  command->add_option("--json", options->json, "File for the figures, - for standard output");
  command
      ->add_option("--pictures", options->pictures,
                   "Folder for pictures of what went wrong (experiment `objects`) or a table of "
                   "every frame (`localise`, `kidnap`, `slam`)")
      ->check(CLI::ExistingDirectory);
  command
      ->add_option("--params", options->params,
                   "The agent's TOML files (experiments `localise`, `kidnap`, `slam`)")
      ->check(CLI::ExistingFile);
  command->add_flag("--list", options->list, "What each experiment measures");
  command->callback([options, &code] { code = evaluate(*options); });
}

}  // namespace kelpie::cli
