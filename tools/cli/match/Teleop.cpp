// SPDX-License-Identifier: Apache-2.0
#include <fmt/core.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <memory>

#include "tools/cli/Commands.h"
#include "tools/cli/Process.h"
#include "tools/cli/Progress.h"
#include "tools/cli/RunDirectory.h"
#include "tools/cli/WholeFile.h"
#include "tools/cli/options/StagingOptions.h"
#include "tools/cli/options/Usage.h"
#include "tools/session/MatchFolder.h"
#include "tools/session/Session.h"
#include "tools/teleop/Keys.h"
#include "tools/teleop/Screen.h"
#include "tools/teleop/Seat.h"

namespace kelpie::cli {
namespace {

namespace fs = std::filesystem;

constexpr double kLongestDrive = 3600.0;  // s
constexpr double kShortestDrive = 1.0;    // s
constexpr double kAfterLastKey = 2.0;     // s: what a key began has an end to be seen
constexpr int kMaxGoals = 99;

struct TeleopOptions {
  SessionOptions session;
  std::string out = "out";
  std::string images = "some";
  std::string keys;
  bool noPicture = false;
};

Expected<std::vector<teleop::TimedKey>> keysOf(const std::string& file) {
  if (file == "-" && isatty(STDIN_FILENO) != 0)
    return Error{"--keys -: standard input is a terminal; leave --keys out to drive by hand"};
  std::ifstream opened;
  if (file != "-" && !std::filesystem::is_directory(file)) opened.open(file);
  std::istream& from = file == "-" ? std::cin : opened;
  const std::string text{std::istreambuf_iterator<char>(from), {}};
  if (from.bad() || (file != "-" && !opened.is_open())) return Error{file + ": cannot be read"};
  return teleop::readKeys(text, file == "-" ? "standard input" : file);
}

// Until x is pressed, or a while after the last key.
double endOf(const std::vector<teleop::TimedKey>& keys) {
  for (const auto& key : keys)
    if (teleop::bindingOf(key.key)->act == teleop::KeyAct::quit)
      return std::max(key.seconds, kShortestDrive);
  return keys.back().seconds + kAfterLastKey;
}

// What happens while somebody drives: on the screen its last line, elsewhere on standard error.
SessionTalk talkTo(teleop::Seat& seat, bool onScreen, std::vector<std::string>& said,
                   LiveLine& live) {
  SessionTalk talk;
  talk.over = [&seat] { return seat.over(); };
  talk.line = [&seat, &said, &live, onScreen](const std::string& line) {
    if (onScreen) {
      seat.note(line);
      said.push_back(line);
      return;
    }
    live.clear();
    fmt::print(stderr, "{}\n", line);
  };
  talk.goal = [line = talk.line](bool own, double seconds) {
    line(fmt::format("{} after {:.1f} s", own ? "GOAL" : "own goal", seconds));
  };
  if (!onScreen) talk.status = [&live](const std::string& line) { live(line); };
  return talk;
}

struct Driven {
  SessionResult result;
  std::string trouble;  // of the terminal or the line to the agent
  bool badInput = false;
};

// The terminal is the driver's from the screen's opening to the end of this function.
Driven drive(const TeleopOptions& options, std::vector<teleop::TimedKey> keys,
             host::Listener listener, MatchFolder& folder) {
  Driven driven;
  std::string noPicture;
  std::unique_ptr<teleop::Screen> screen;
  std::vector<std::string> said;
  if (options.keys.empty()) {
    auto opened = teleop::Screen::open(!options.noPicture, noPicture);
    if (!opened) return {{}, opened.error(), true};
    screen = std::move(*opened);
  }
  if (!noPicture.empty()) fmt::print(stderr, "kelpie: no picture: {}\n", noPicture);
  LiveLine live;
  teleop::Seat seat(std::move(listener), std::move(keys), screen.get());
  SessionTalk talk = talkTo(seat, screen != nullptr, said, live);
  talk.logs = [&folder] { return folder.moveEarlier(); };
  driven.result = runSession(options.session, talk);
  driven.trouble = seat.leave();
  live.finish();
  screen.reset();
  for (const auto& line : said) fmt::print(stderr, "{}\n", line);
  return driven;
}

int report(const TeleopOptions& options, const Driven& driven) {
  const SessionResult& result = driven.result;
  if (!driven.trouble.empty())
    return fail(driven.trouble, driven.badInput ? kExitBadInput : kExitMachine);
  if (!result.trouble.empty())
    return fail(result.trouble, result.badInput ? kExitBadInput : kExitMachine);
  if (!result.logTrouble.empty()) return fail(result.logTrouble, kExitMachine);
  std::error_code error;
  const double megabytes = 1e-6 * static_cast<double>(fs::file_size(options.session.log, error));
  fmt::print("{}: log, {:.0f} MB; kelpie info, show, film and replay --check read it\n",
             options.session.log, megabytes);
  fmt::print("drove {:.1f} simulated seconds (seed {})\n", result.seconds, options.session.seed);
  const bool cutShort = result.interrupted && !options.keys.empty();
  return cutShort ? fail("interrupted", kExitInterrupted) : kExitDone;
}

int runTeleop(TeleopOptions& options) {
  std::vector<teleop::TimedKey> keys;
  SessionOptions& session = options.session;
  session.realTime = options.keys.empty();
  session.seconds = kLongestDrive;
  session.goals = kMaxGoals;
  session.images = options.images == "all" ? ImagesKept::all : ImagesKept::some;
  if (!options.keys.empty()) {
    auto read = keysOf(options.keys);
    if (!read) return fail(read.error(), kExitBadInput);
    keys = std::move(*read);
    session.seconds = endOf(keys);
  }
  catchInterrupts();
  auto folder = MatchFolder::take(options.out, "teleop");
  if (!folder) return fail(folder.error(), kExitBadInput);
  for (const auto& note : folder->notes()) fmt::print(stderr, "{}\n", note);
  session.log = folder->file("teleop.mcap");

  const RunDirectory runDirectory;
  if (!runDirectory.ready()) return fail("cannot make a temporary folder", kExitMachine);
  session.driver = runDirectory.path("driver");
  auto listener = host::Listener::open(session.driver);
  if (!listener) return fail(listener.error(), kExitMachine);
  return report(options, drive(options, std::move(keys), std::move(*listener), *folder));
}

std::string helpOnKeys() {
  std::string text = "Keys:";
  for (const std::string& line : teleop::keyHelp()) text += "\n  " + line;
  return text;
}

}  // namespace

void addTeleop(CommandLine& app, int& code) {
  auto command = app.subcommand(
      "teleop", "Drive the robot of the simulated world with keys, in a terminal or from a file");
  auto options = std::make_shared<TeleopOptions>();
  auto& session = options->session;
  command.option("--keys", options->keys,
                 "Keys of a file (- for standard input) in place of the terminal's: lines "
                 "TIME KEY, seconds and a key or up, down, left, right, space; # begins a "
                 "comment. Ends at x, or two seconds after the last key");
  command.option("--out", options->out, "Folder for teleop.mcap").showDefault();
  command.option("--seed", session.seed, "Start pose, ball, noise and slip")
      .check(inRange(0.0, kLargestSeed))
      .showDefault();
  command.option("--scenario", session.scenario, "What is on the field at the start")
      .check(oneOf({"empty-goal", "kickoff"}))
      .showDefault();
  addSideOptions(command, session.field, session.team);
  command.flag("--physical,!--fast", session.physical,
               "A body with masses, servos and contacts (the default), or a kinematic one");
  command
      .option("--images", options->images,
              "Which images the log keeps, as play's: some "
              "or all")
      .check(oneOf({"some", "all"}))
      .showDefault();
  command.flag("--no-picture", options->noPicture, "One line instead of the whole screen");
  command.footer(helpOnKeys());
  command.callback([options, &code] { code = runTeleop(*options); });
}

}  // namespace kelpie::cli
