// SPDX-License-Identifier: Apache-2.0
#include "tools/cli/options/Usage.h"

#include <fmt/core.h>

#include <CLI/CLI.hpp>

#include "tools/cli/Version.h"

namespace kelpie::cli {
namespace {

constexpr int kUsageError = 2;

// The subcommand that was being read, as the user wrote it.
std::string commandOf(const CLI::App& app) {
  const auto chosen = app.get_subcommands();
  return app.get_name() + (chosen.empty() ? "" : " " + commandOf(*chosen.front()));
}

// A word that is not known is reported first: what seems to be missing is often only misspelt.
std::string whatIsWrong(const CLI::App& app, const CLI::Error& error) {
  const auto unknown = app.remaining(true);
  const bool missing = error.get_exit_code() == static_cast<int>(CLI::ExitCodes::RequiredError);
  if (!missing || unknown.empty()) return error.what();
  return "'" + unknown.front() + "' is not known";
}

}  // namespace

int parseOptions(CommandLine& line, int argc, char** argv, bool& done) {
  CLI::App& app = line.app();
  done = true;
  app.set_version_flag("--version", versionLine,
                       "Version, commit and field lists (logs of the same field lists fit)");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return app.exit(error);
    fmt::print(stderr, "{}: {}; `{} --help` tells more\n", app.get_name(), whatIsWrong(app, error),
               commandOf(app));
    return kUsageError;
  }
  done = false;
  return 0;
}

}  // namespace kelpie::cli
