// SPDX-License-Identifier: Apache-2.0
#include "tools/cli/match/Watch.h"

#include <chrono>
#include <filesystem>
#include <thread>
#include <utility>

#include "tools/cli/Process.h"
#include "tools/cli/options/Config.h"
#include "tools/cli/options/ServeOptions.h"
#include "tools/session/Teams.h"

namespace kelpie::cli {
namespace {

namespace fs = std::filesystem;

// A zip of them is shown to nobody.
std::map<std::string, std::string> behavioursOf(const SessionOptions& session) {
  std::map<std::string, std::string> folders;
  const auto add = [&folders](const std::string& team, const std::string& pycode) {
    const std::string folder = pycode.empty() ? defaultScripts() : pycode;
    std::error_code error;
    if (fs::is_directory(folder, error)) folders.emplace(team, folder);
  };
  add(session.team, session.pycode);
  for (const OtherRobot& other : session.others) add(other.team, other.pycode);
  return folders;
}

}  // namespace

void addWatchOptions(CommandLine& command, WatchOptions& options) {
  command.flag("--studio", options.studio,
               "Watch it in a browser while it is played, by the clock and until Ctrl-C: pause, "
               "step, drag the ball, change behaviours; keeps the logs of all robots");
  command.flag("--live", options.live,
               "Serve it to Foxglove and Lichtblick while it is played; keeps the logs of all "
               "robots");
  addServeOptions(command, options.web);
}

void prepareWatched(const WatchOptions& options, SessionOptions& session) {
  session.live = options.any();
  session.allLogs = session.allLogs || (options.any() && !session.others.empty());
  session.orders = options.studio;
  session.realTime = session.realTime || options.studio;
}

Watch::Watch(const WatchOptions& options, std::shared_ptr<studio::MatchLink> link,
             std::unique_ptr<studio::StudioThread> studio)
    : options_(options), link_(std::move(link)), studio_(std::move(studio)) {}

Expected<std::unique_ptr<Watch>> Watch::begin(const WatchOptions& options,
                                              const SessionOptions& session,
                                              const std::string& folder) {
  studio::StudioOptions served;
  served.web = options.web;
  served.folder = folder;
  const auto link = std::make_shared<studio::MatchLink>(*body::fieldDescription(session.field),
                                                        robotsOf(session));
  if (options.studio) served.link = link;
  if (options.studio) served.behaviours = behavioursOf(session);
  auto studio = studio::StudioThread::begin(served);
  if (!studio) return Error{studio.error()};
  return std::unique_ptr<Watch>(new Watch(options, link, std::move(*studio)));
}

std::vector<std::string> Watch::lines() const {
  const std::string url = studio_->url();
  std::vector<std::string> lines;
  if (options_.studio) lines.push_back("studio: " + url);
  lines.push_back("live: ws" + url.substr(url.find(':')) + "  (Foxglove, Lichtblick)");
  return lines;
}

void Watch::listenTo(SessionTalk& talk) {
  if (!options_.studio) return;
  const auto link = link_;
  talk.orders = [link] { return link->nextOrder(); };
  talk.line = [link, line = talk.line](const std::string& said) {
    link->say(said);
    line(said);
  };
}

void Watch::stay() {
  while (options_.studio && !interrupted())
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
}

}  // namespace kelpie::cli
