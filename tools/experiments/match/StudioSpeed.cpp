// SPDX-License-Identifier: Apache-2.0
// Whether the studio keeps up: how long its page takes to open the logs of a match and to go
// elsewhere in them, how many pictures a second it draws, and how much longer a match lasts that is
// watched. By the clock, in a Chromium that draws in software: figures of one's own PC, never a
// test. Needs node, Chromium and the built page.
#include <array>
#include <chrono>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>

#include "tools/cli/DataFolder.h"
#include "tools/cli/Process.h"
#include "tools/cli/RunDirectory.h"
#include "tools/experiments/harness/Statistics.h"
#include "tools/experiments/harness/Trials.h"
#include "tools/session/MatchFolder.h"
#include "tools/session/Session.h"
#include "tools/session/Teams.h"
#include "tools/studio/StudioThread.h"

namespace kelpie::experiments {
namespace {

namespace fs = std::filesystem;

constexpr double kMinutes = 10.0;         // of play in the match whose logs are opened
constexpr double kWatchedSeconds = 60.0;  // of each match that is watched

// Its programs are in the source tree only.
std::string pageFolder() { return cli::dataFolder() + "/tools/studio/page/"; }

// What both kinds of match have in common: two teams, and the logs of all robots.
Expected<cli::SessionOptions> match(const Request& request, const cli::MatchFolder& folder,
                                    double seconds, std::uint64_t seed) {
  cli::SessionOptions session;
  auto plan = cli::teamPlan("4v4");
  if (!plan) return Error{plan.error()};
  const Status teams = cli::useTeams(*plan, session);
  if (!teams) return Error{teams.error()};
  session.seed = seed;
  session.seconds = seconds;
  session.goals = 99;
  session.physical = !request.fast;
  session.log = folder.file("match.mcap");
  session.images = cli::ImagesKept::planes;
  session.allLogs = true;
  return session;
}

// As `kelpie studio` and `kelpie play --live` do.
Expected<std::unique_ptr<studio::StudioThread>> served(const std::string& folder, bool recorded) {
  studio::StudioOptions options;
  options.web.port = 0;
  options.folder = folder;
  if (recorded) options.logs = {folder};
  return studio::StudioThread::begin(options);
}

Expected<std::string> play(const cli::SessionOptions& session) {
  cli::SessionTalk quiet;
  quiet.line = [](const std::string&) {};
  const cli::SessionResult result = cli::runSession(session, quiet);
  if (!result.trouble.empty()) return Error{result.trouble};
  return session.log;
}

// Viewers leave the processor to the match, as those on other machines do.
Expected<cli::Process> node(const std::vector<std::string>& words, int nice) {
  std::vector<std::string> argv = {"/usr/bin/nice", "-n", std::to_string(nice), "node"};
  argv.insert(argv.end(), words.begin(), words.end());
  return cli::Process::start(argv, true);
}

// The page's own figures.
Expected<Json> lookAt(const std::string& url, std::uint64_t seed) {
  auto looking = node({pageFolder() + "measure.mjs", url, std::to_string(seed)}, 0);
  if (!looking) return Error{looking.error()};
  std::string line, last;
  while (!looking->ended())
    if (looking->readLine(line, 200)) last = line;
  while (looking->readLine(line, 0)) last = line;
  const auto figures = Json::parse(last, nullptr, false);
  if (looking->wait() != 0 || !figures.is_object())
    return Error{"the page was not measured (tools/build studio, tools/install browser): " + last};
  return figures;
}

Expected<Json> openMatch(const Request& request, const std::string& scratch) {
  auto folder = cli::MatchFolder::take(scratch + "/recorded");
  if (!folder) return Error{folder.error()};
  const double minutes = request.minutes > 0.0 ? request.minutes : kMinutes;
  const auto session = match(request, *folder, 60.0 * minutes, request.seed);
  const auto played = session ? play(*session) : Error{session.error()};
  if (!played) return Error{played.error()};
  const auto studio = served(folder->path(), true);
  if (!studio) return Error{studio.error()};
  return lookAt((*studio)->url(), request.seed);
}

enum class Watched { nobody, two, deaf };

// Seconds by the clock that a match takes.
Expected<double> watchedMatch(const Request& request, const std::string& scratch, Watched watched,
                              std::uint64_t seed) {
  auto folder = cli::MatchFolder::take(scratch + "/watched");
  if (!folder) return Error{folder.error()};
  auto session = match(request, *folder, kWatchedSeconds, seed);
  if (!session) return Error{session.error()};
  session->live = true;
  const auto studio = served(folder->path(), false);
  if (!studio) return Error{studio.error()};
  const std::string url = (*studio)->url() + (watched == Watched::deaf ? "/live" : "/");
  std::vector<cli::Process> viewers;
  const std::vector<std::string> words = {pageFolder() + "watch.mjs", url,
                                          watched == Watched::deaf ? "deaf" : "all"};
  for (int i = 0; i < (watched == Watched::nobody ? 0 : watched == Watched::two ? 2 : 1); ++i) {
    auto viewer = node(words, 19);
    if (!viewer) return Error{viewer.error()};
    viewers.push_back(std::move(*viewer));
  }
  const auto start = std::chrono::steady_clock::now();
  const auto played = play(*session);
  if (!played) return Error{played.error()};
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

// How much longer the same match takes, each beside one that nobody watches.
Expected<Json> slowdowns(const Request& request, const std::string& scratch) {
  Values two, deaf;
  for (int trial = 0; trial < request.trials; ++trial) {
    const std::uint64_t seed = request.seed + static_cast<std::uint64_t>(trial);
    std::array<double, 3> seconds{};
    for (const Watched watched : {Watched::nobody, Watched::two, Watched::deaf}) {
      const auto took = watchedMatch(request, scratch, watched, seed);
      if (!took) return Error{took.error()};
      seconds[static_cast<std::size_t>(watched)] = *took;
    }
    two.push_back(100.0 * (seconds[1] / seconds[0] - 1.0));
    deaf.push_back(100.0 * (seconds[2] / seconds[0] - 1.0));
    if (request.progress) request.progress(trial + 1, request.trials);
  }
  return Json{{"slowdown_pct", percentile(two, 0.5)}, {"slowdown_deaf_pct", percentile(deaf, 0.5)}};
}

Expected<Json> studioSpeed(const Request& request) {
  const cli::RunDirectory scratch;
  if (!scratch.ready()) return Error{"cannot make a temporary folder"};
  auto figures = openMatch(request, scratch.path("match"));
  if (!figures) return figures;
  const auto slower = slowdowns(request, scratch.path("match"));
  if (!slower) return slower;
  figures->update(*slower);
  return figures;
}

const Registration kStudio("studio",
                           "opening, seeking, drawing in the studio; what being watched costs",
                           {Option::trials, Option::seed, Option::fast, Option::minutes}, 5,
                           studioSpeed);

}  // namespace
}  // namespace kelpie::experiments
