// SPDX-License-Identifier: Apache-2.0
// kelpie-experiments: what `kelpie evaluate` runs. A program of its own, since the experiments take
// longer to compile than everything that a match needs.
#include <fmt/core.h>

#include <algorithm>
#include <exception>

#include "tools/cli/DataFolder.h"
#include "tools/cli/JsonText.h"
#include "tools/cli/Process.h"
#include "tools/cli/Progress.h"
#include "tools/cli/Terminal.h"
#include "tools/cli/WholeFile.h"
#include "tools/cli/options/Usage.h"
#include "tools/experiments/harness/Experiment.h"

namespace kelpie::experiments {
namespace {

struct EvaluateOptions {
  std::string name;
  Request request;
  std::string json = "-";
  bool list = false;
};

std::string listed(const std::vector<Experiment>& experiments) {
  std::string lines;
  for (const Experiment& one : experiments)
    lines += fmt::format("  {:22} {}\n", one.name, one.measures);
  return lines;
}

int listExperiments(const std::vector<Experiment>& experiments) {
  for (const Experiment& one : experiments) {
    fmt::print("{:22} {}\n", one.name, one.measures);
    std::string options =
        one.uses.has(Option::trials) ? fmt::format("--trials (default {})", one.trials) : "";
    for (const Option option : kAllOptions)
      if (option != Option::trials && one.uses.has(option))
        options += fmt::format("{}{}", options.empty() ? "" : ", ", nameOf(option));
    if (!options.empty()) fmt::print("{:22} {}\n", "", options);
  }
  return cli::kExitDone;
}

void addOptions(cli::CommandLine& app, EvaluateOptions& options) {
  Request& request = options.request;
  app.option("NAME", options.name, "The experiment");
  app.option(nameOf(Option::trials), request.trials, "How often (default: the experiment's own)")
      .check(cli::integerInRange(1, 1000000));
  app.option(nameOf(Option::seed), request.seed, "Seed of the first trial")
      .check(cli::inRange(0.0, cli::kLargestSeed))
      .showDefault();
  cli::addRandomisationOptions(app, request.randomised);
  app.option(nameOf(Option::params), request.params, "The agent's TOML files")
      .check(cli::existingFile());
  app.option(nameOf(Option::field), request.field,
             "The field: 2006 (the default), osaka2005 or 2004")
      .check(cli::oneOf({"2006", "osaka2005", "2004"}));
  app.option(nameOf(Option::traces), request.traces, "Folder for tables of every frame, as CSV")
      .check(cli::existingFolder());
  app.option(nameOf(Option::pictures), request.pictures, "Folder for pictures of what went wrong")
      .check(cli::existingFolder());
  app.flag(nameOf(Option::fast), request.fast,
           "Kinematic bodies in place of those with masses and servos; staged scenes and "
           "time-to-score also take percepts in place of images");
  app.option(nameOf(Option::minutes), request.minutes,
             "Minutes of play in each match (default: the experiment's own)")
      .check(cli::inRange(0.1, 60.0));
  app.option(nameOf(Option::side), request.sideA, "Folder of a team (default: teams/kelpie)")
      .checkTeam(cli::dataFolder());
  app.option(nameOf(Option::opponents), request.sideB,
             "Folder of the team that plays against it (default: the experiment's own)")
      .checkTeam(cli::dataFolder());
  app.option("--json", options.json, "File for the figures, - for standard output");
  app.flag("--list", options.list, "Each experiment, or NAME alone, with the options that it uses");
}

Options givenOptions(const cli::CommandLine& app) {
  Options given;
  for (const Option option : kAllOptions)
    if (app.count(nameOf(option)) > 0) given.add(option);
  return given;
}

Expected<Json> measureWithProgress(const Experiment& experiment, Request& request) {
  cli::Progress progress(experiment.name, "trials");
  request.progress = [&progress](int done, int all) {
    progress(static_cast<std::size_t>(done), static_cast<std::size_t>(all));
  };
  return measure(experiment, request);
}

int run(const Experiment& experiment, EvaluateOptions& options) {
  const Expected<Json> figures = measureWithProgress(experiment, options.request);
  if (!figures) return cli::fail(figures.error(), cli::kExitBadInput);
  const std::string text = cli::jsonText(*figures, 2) + "\n";
  if (cli::writeWhole(options.json, text)) return cli::kExitDone;
  cli::writeWhole("-", text);  // what took minutes is not lost
  return cli::fail(options.json + ": cannot be written", cli::kExitBadInput);
}

int evaluate(const std::vector<Experiment>& experiments, Options given, EvaluateOptions& options) {
  if (options.list && options.name.empty()) return listExperiments(experiments);
  const auto found = std::find_if(experiments.begin(), experiments.end(),
                                  [&](const Experiment& one) { return one.name == options.name; });
  if (found == experiments.end())
    return cli::fail(
        (options.name.empty() ? "name an experiment" : "no experiment '" + options.name + "'") +
            "; `kelpie evaluate --list` tells which there are",
        cli::kExitBadInput);
  if (options.list) return listExperiments({*found});
  const Status usable = checkOptions(*found, given);
  if (!usable) return cli::fail(usable.error(), cli::kExitBadInput);
  if (!cli::canWrite(options.json))
    return cli::fail(options.json + ": cannot be written", cli::kExitBadInput);
  if (!given.has(Option::trials)) options.request.trials = found->trials;
  return run(*found, options);
}

}  // namespace
}  // namespace kelpie::experiments

int main(int argc, char** argv) {
  using namespace kelpie;
  cli::useTargetMaths(argv);
  const auto known = experiments::sortedByName(experiments::Registration::all());
  if (!known) return cli::fail(known.error(), cli::kExitBadInput);
  cli::ProgramLine app{"Measure: one JSON object of plain figures", "kelpie evaluate"};
  app.footer("Experiments:\n" + experiments::listed(*known));
  experiments::EvaluateOptions options;
  experiments::addOptions(app, options);
  bool done = false;
  const int usage = cli::parseOptions(app, argc, argv, done);
  if (done) return usage;
  try {
    return experiments::evaluate(*known, experiments::givenOptions(app), options);
  } catch (const std::exception& error) {
    return cli::fail(error.what(), cli::kExitBadInput);
  }
}
