// SPDX-License-Identifier: Apache-2.0
#include "tools/cli/match/StrangerOptions.h"

#include <fmt/core.h>

#include <algorithm>
#include <cctype>
#include <cstring>
#include <filesystem>
#include <sstream>

#include "tools/cli/Process.h"
#include "tools/session/SessionCommands.h"

namespace kelpie::cli {
namespace {

// Words that a shell reads in its own way may be anything; a plain one is a program or none.
bool isPlain(const std::string& word) {
  return !word.empty() && std::all_of(word.begin(), word.end(), [](unsigned char c) {
    return std::isalnum(c) != 0 || std::strchr("_-+./", c) != nullptr;
  });
}

// Asked of the shell that will start it. Where that cannot be, the match will tell.
bool canStart(const std::string& word) {
  if (!isPlain(word)) return true;
  auto asked = Process::startGroup({"/bin/sh", "-c", "command -v -- \"$0\" >/dev/null 2>&1", word});
  return !asked || asked->wait() == 0;
}

}  // namespace

void addStrangerOptions(CommandLine& command, SessionOptions& session) {
  for (const std::string team : {"red", "blue"})
    command
        .option("--" + team + "-agent", team == "red" ? session.redAgent : session.blueAgent,
                "Command that starts somebody else's agent for each " + team +
                    " robot in place of Kelpie's (examples/agent/README.md)")
        .check(notEmpty())
        .excludes("--" + team)
        .excludes("--percepts");
  command
      .option("--agent-limit", session.agentLimit,
              "Seconds of real time that such an agent has for each answer; then the match goes on "
              "without it")
      .check(inRange(0.001, 60.0))
      .showDefault();
  command
      .option("--agent-wait", session.agentWait,
              "Seconds until such an agent must be there; then the match begins without it")
      .check(inRange(0.0, 600.0))
      .showDefault();
}

Status checkStrangerOptions(const CommandLine& command, const SessionOptions& session) {
  if (!session.redAgent.empty() || !session.blueAgent.empty()) return Done{};
  for (const char* option : {"--agent-limit", "--agent-wait"})
    if (command.count(option) > 0)
      return Error{std::string(option) + " is for the agents of --red-agent and --blue-agent"};
  return Done{};
}

Status checkStrangers(const SessionOptions& session) {
  for (const char* team : {"red", "blue"}) {
    const TeamColour colour = std::string(team) == "red" ? TeamColour::red : TeamColour::blue;
    const auto robots = strangersOf(session);
    const bool plays = std::any_of(robots.begin(), robots.end(),
                                   [&](const auto& robot) { return robot.team == colour; });
    if (!session.strangerOf(team).empty() && !plays)
      return Error{fmt::format("--{0}-agent: no {0} robot plays (--robots 4v4)", team)};
    std::string program;
    std::istringstream(session.strangerOf(team)) >> program;
    if (!canStart(program)) return Error{fmt::format("--{}-agent: no program {}", team, program)};
  }
  return Done{};
}

// The first word with a folder, or the first.
std::string programIn(const std::string& command) {
  std::istringstream words(command);
  std::string first, word;
  words >> first;
  for (word = first; word.find('/') == std::string::npos;)
    if (!(words >> word)) return first;
  return std::filesystem::path(word).stem().string();
}

}  // namespace kelpie::cli
