// SPDX-License-Identifier: Apache-2.0
// `kelpie studio`: recorded logs and a match that is being played, in a browser.
#include "tools/studio/Studio.h"

#include <fmt/core.h>

#include <filesystem>
#include <memory>

#include "tools/cli/Commands.h"
#include "tools/cli/Process.h"
#include "tools/cli/options/ServeOptions.h"

namespace kelpie::cli {
namespace {

namespace fs = std::filesystem;

constexpr const char* kUsualFolder = "out";

struct StudioCommand {
  std::vector<std::string> sources;
  web::ServerParams web;
};

// A folder is one where a match may be played, too; the first counts.
studio::StudioOptions optionsOf(const StudioCommand& command) {
  studio::StudioOptions options;
  options.web = command.web;
  options.logs = command.sources;
  std::error_code error;
  for (const std::string& source : command.sources)
    if (options.folder.empty() && fs::is_directory(source, error)) options.folder = source;
  return options;
}

// A match may begin in the usual folder later.
int serve(StudioCommand command) {
  std::error_code error;
  const bool usual = command.sources.empty();
  if (usual && fs::is_directory(kUsualFolder, error)) command.sources = {kUsualFolder};
  catchInterrupts();
  studio::StudioOptions options = optionsOf(command);
  if (usual) options.folder = kUsualFolder;
  const auto studio = studio::Studio::open(options);
  if (!studio) return fail(studio.error(), kExitBadInput);
  fmt::print("studio: {}  (Ctrl-C ends it)\n", (*studio)->url());
  std::fflush(stdout);
  (*studio)->run(interrupted);
  return kExitDone;
}

}  // namespace

void addStudio(CommandLine& app, int& code) {
  auto command = app.subcommand(
      "studio",
      "Look at matches in a browser: field in 3D, cameras, decisions, time line; recorded logs, or "
      "a match that is being played in a folder");
  auto options = std::make_shared<StudioCommand>();
  command
      .option("SOURCES", options->sources,
              "Logs, and folders of matches such as out (default: out)")
      .check(existingPath());
  addServeOptions(command, options->web);
  command.callback([options, &code] { code = serve(*options); });
}

}  // namespace kelpie::cli
