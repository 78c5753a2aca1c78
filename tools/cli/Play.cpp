// SPDX-License-Identifier: Apache-2.0
#include <fmt/core.h>

#include <chrono>
#include <filesystem>
#include <memory>

#include "tools/cli/Commands.h"
#include "tools/cli/Config.h"
#include "tools/cli/Film.h"
#include "tools/cli/Process.h"
#include "tools/cli/Session.h"

namespace kelpie::cli {
namespace {

namespace fs = std::filesystem;

struct PlayOptions {
  SessionOptions session;
  std::string out = "out";
  bool noFilm = false;
};

// On a terminal one line that is drawn again; quiet in a pipe.
class StatusPrinter {
 public:
  void operator()(const std::string& line) {
    if (!onTerminal()) return;
    ++lines_;
    fmt::print(stderr, "\r\033[K{}", line);
  }
  void finish() const {
    if (onTerminal() && lines_ > 0) fmt::print(stderr, "\n");
  }

 private:
  int lines_ = 0;
};

int makePictures(const PlayOptions& options) {
  const std::string log = options.session.log;
  const Status picture = drawMatchPicture(log, options.out + "/match.png");
  if (!picture) return complain(picture.error(), kCheckFailed);
  if (!options.noFilm) {
    const Status film = filmMatch(log, options.out + "/match.mp4", {});
    if (!film) return complain(film.error(), kCheckFailed);
  }
  for (const char* name : {"match.png", "match.mp4", "match.mcap"}) {
    const std::string path = options.out + "/" + name;
    if (fs::exists(path)) fmt::print("{}\n", path);
  }
  return kDone;
}

// What is wrong with the options is told before anything is started or an earlier match replaced.
Status checkConfig(const SessionOptions& session) {
  ConfigOptions config;
  config.field = session.field;
  config.team = session.team;
  config.colourTable = session.colourTable;
  config.ring = session.ring;
  config.params = session.params;
  const auto made = makeConfig(config);
  if (!made) return Error{made.error()};
  return session.pycode.empty() ? Status(Done{}) : checkScripts(session.pycode);
}

int play(PlayOptions& options) {
  const Status checked = checkConfig(options.session);
  if (!checked) return complain(checked.error(), kBadInput);
  catchInterrupts();
  std::error_code error;
  fs::create_directories(options.out, error);
  if (error) return complain(options.out + ": " + error.message(), kBadInput);
  options.session.log = options.out + "/match.mcap";

  const auto start = std::chrono::steady_clock::now();
  StatusPrinter printer;
  const SessionResult result =
      runSession(options.session, [&printer](const std::string& line) { printer(line); });
  printer.finish();
  // An earlier match stays until there is another; then its pictures would be of the wrong one.
  if (result.logged)
    for (const char* name : {"match.png", "match.mp4"}) fs::remove(options.out + "/" + name, error);
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
  if (!result.trouble.empty())
    return complain(result.trouble, result.badInput ? kBadInput : kCheckFailed);
  if (result.goals > 0)
    fmt::print("GOAL after {:.1f} s", result.firstGoal);
  else
    fmt::print("no goal in {:.0f} s", result.seconds);
  fmt::print(" (seed {}, {:.1f} simulated seconds in {:.1f} s)\n", options.session.seed,
             result.seconds, took.count());
  const int pictures = makePictures(options);
  if (pictures != kDone) return pictures;
  return result.goals > 0 ? kDone : kCheckFailed;
}

}  // namespace

void addPlay(CLI::App& app, int& code) {
  auto* command = app.add_subcommand(
      "play", "One robot plays in the simulated world; exit code 0 when it scores");
  auto options = std::make_shared<PlayOptions>();
  auto& session = options->session;
  command->add_option("--out", options->out, "Folder for match.mcap, match.mp4 and match.png")
      ->capture_default_str();
  command->add_option("--seed", session.seed, "Start pose, ball, noise and slip")
      ->check(inRange(0.0, kLargestSeed))
      ->capture_default_str();
  command->add_option("--seconds", session.seconds, "Simulated time at most")
      ->check(inRange(1.0, 3600.0))
      ->capture_default_str();
  command->add_option("--goals", session.goals, "Ends after so many goals")
      ->check(CLI::Range(1, 99))
      ->capture_default_str();
  command->add_option("--scenario", session.scenario, "What is on the field at the start")
      ->check(CLI::IsMember({"empty-goal", "kickoff"}))
      ->capture_default_str();
  command->add_option("--field", session.field, "2006, osaka2005 or 2004")
      ->check(CLI::IsMember({"2006", "osaka2005", "2004"}))
      ->capture_default_str();
  command->add_option("--team", session.team, "red attacks the blue goal")
      ->check(CLI::IsMember({"red", "blue"}))
      ->capture_default_str();
  command->add_option("--pycode", session.pycode, "Folder of behaviours (default: pycode/)")
      ->check(CLI::ExistingPath);
  command->add_option("--params", session.params, "TOML files, general to specific")
      ->check(CLI::ExistingFile);
  command->add_option("--colour-table", session.colourTable, "Colour table file")
      ->check(CLI::ExistingFile);
  command->add_option("--ring", session.ring, "Ring correction: none, 2006 or a file")
      ->capture_default_str();
  command->add_option("--drop-rate", session.dropRate, "Share of images lost on the way")
      ->check(inRange(0.0, 1.0));
  command->add_option("--without", session.artefactsOff, "Camera artefacts switched off")
      ->check(CLI::IsMember({"ring", "noise", "shift", "rolling", "blur", "spectators"}));
  command->add_flag("--no-film", options->noFilm, "Leave out match.mp4");
  command->callback([options, &code] { code = play(*options); });
}

}  // namespace kelpie::cli
