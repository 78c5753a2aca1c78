// SPDX-License-Identifier: Apache-2.0
#include "tools/cli/Session.h"

#include <fmt/core.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string_view>
#include <thread>

#include "tools/cli/AgentTalk.h"
#include "tools/cli/Logs.h"
#include "tools/cli/Process.h"

namespace kelpie::cli {
namespace {

namespace fs = std::filesystem;

// A private folder for the socket and the two halves of the log; goes with the object.
class Workshop {
 public:
  Workshop() {
    std::string pattern = (fs::temp_directory_path() / "kelpie-XXXXXX").string();
    if (mkdtemp(pattern.data()) != nullptr) folder_ = pattern;
  }
  ~Workshop() {
    std::error_code ignored;
    if (!folder_.empty()) fs::remove_all(folder_, ignored);
  }
  Workshop(const Workshop&) = delete;
  Workshop& operator=(const Workshop&) = delete;

  bool ready() const { return !folder_.empty(); }
  std::string path(const char* name) const { return (folder_ / name).string(); }

 private:
  fs::path folder_;
};

std::vector<std::string> worldCommand(const SessionOptions& options, const Workshop& workshop) {
  std::vector<std::string> argv = {programFolder() + "/kelpie-world",
                                   "--socket",
                                   workshop.path("world"),
                                   "--robots",
                                   "1",
                                   "--seed",
                                   std::to_string(options.seed),
                                   "--field",
                                   options.field,
                                   "--scenario",
                                   options.scenario,
                                   "--seconds",
                                   std::to_string(options.seconds),
                                   "--goals",
                                   std::to_string(options.goals),
                                   "--result",
                                   workshop.path("result.json")};
  if (!options.log.empty()) {
    argv.insert(argv.end(), {"--truth", workshop.path("world.mcap")});
  }
  for (const auto& artefact : options.artefactsOff) argv.push_back("--no-" + artefact);
  return argv;
}

std::vector<std::string> agentCommand(const SessionOptions& options, const Workshop& workshop) {
  std::vector<std::string> argv = {programFolder() + "/kelpie-agent",
                                   "--socket",
                                   workshop.path("world"),
                                   "--team",
                                   options.team,
                                   "--field",
                                   options.field,
                                   "--ring",
                                   options.ring,
                                   "--drop-rate",
                                   std::to_string(options.dropRate),
                                   "--seed",
                                   std::to_string(options.seed),
                                   "--status"};
  if (!options.log.empty()) argv.insert(argv.end(), {"--log", workshop.path("agent.mcap")});
  if (!options.pycode.empty()) argv.insert(argv.end(), {"--pycode", options.pycode});
  if (!options.colourTable.empty())
    argv.insert(argv.end(), {"--colour-table", options.colourTable});
  for (const auto& file : options.params) argv.insert(argv.end(), {"--params", file});
  return argv;
}

void readResult(const std::string& path, bool blue, SessionResult& result) {
  std::ifstream file(path);
  const auto json = nlohmann::json::parse(file, nullptr, false);
  if (!json.is_object()) {
    result.trouble = "the world left no result";
    return;
  }
  const std::string own = blue ? "blue" : "red";
  const std::string other = blue ? "red" : "blue";
  result.goals = json.value(own + "_goals", 0);
  result.ownGoals = json.value(other + "_goals", 0);
  result.outs = json.value("outs", 0);
  result.seconds = json.value("seconds", 0.0);
  if (result.goals > 0) result.firstGoal = json.value("first_" + own + "_goal_s", -1.0);
}

// What the agent prints: status lines for the caller, its last complaint for the end, the rest (a
// script's error) for the user at once.
struct AgentTalk {
  std::string last = "before the first frame";
  std::string complaint;
  bool began = false;
  std::string early;  // said before the match began; a complaint then says all in one line

  void hear(const std::string& line, const StatusLine& status) {
    const std::string_view text = line;
    if (text.substr(0, kStatusMark.size()) == kStatusMark) {
      last = text.substr(kStatusMark.size());
      if (!began) fmt::print(stderr, "{}", early);
      began = true;
      if (status) status(last);
    } else if (text.substr(0, kComplaintMark.size()) == kComplaintMark) {
      complaint = text.substr(kComplaintMark.size());
    } else if (began) {
      fmt::print(stderr, "{}\n", line);
    } else {
      early += line + "\n";
    }
  }
};

// Runs until both have ended. The world's death ends the agent (its socket closes); an agent that
// ends in trouble takes the world with it.
void watch(Process& world, Process& agent, const StatusLine& status, SessionResult& result) {
  AgentTalk talk;
  std::string line;
  while (!agent.ended()) {
    while (agent.readLine(line, 50)) talk.hear(line, status);
    if (interrupted()) world.terminate();  // the agent then closes its log and ends
  }
  while (agent.readLine(line, 0)) talk.hear(line, status);
  const int agentCode = agent.wait();
  // A world that was killed may be a moment behind the agent that its end has stopped.
  for (int i = 0; i < 20 && agentCode == 1 && !world.ended(); ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  const bool alive = !world.ended();
  if (alive && agentCode != 0) world.terminate();
  const int worldCode = world.wait();
  if (interrupted())
    result.trouble = "interrupted; last: " + talk.last;
  else if (!alive && worldCode >= 128)
    result.trouble =
        fmt::format("the world died (signal {}); last: {}", worldCode - 128, talk.last);
  else if (agentCode >= 128)
    result.trouble =
        fmt::format("the agent died (signal {}); last: {}", agentCode - 128, talk.last);
  else if (agentCode != 0)
    result.trouble = talk.complaint.empty() ? "the agent gave up" : talk.complaint;
  else if (worldCode != 0)
    result.trouble = fmt::format("the world stopped with code {}", worldCode);
  result.badInput = agentCode == 2;
}

void play(const SessionOptions& options, const StatusLine& status, const Workshop& workshop,
          SessionResult& result) {
  auto world = Process::start(worldCommand(options, workshop), false);
  auto agent = Process::start(agentCommand(options, workshop), true);
  if (!world || !agent) {
    result.trouble = world ? agent.error() : world.error();
    return;
  }
  watch(*world, *agent, status, result);
  if (!options.log.empty() && fs::exists(workshop.path("agent.mcap")) && !result.badInput) {
    std::vector<std::string> halves;
    for (const char* half : {"agent.mcap", "world.mcap"})
      if (fs::exists(workshop.path(half))) halves.push_back(workshop.path(half));
    const Status merged = mergeLogs(halves, options.log);
    if (!merged) result.trouble = merged.error();
    result.logged = merged.ok();
  }
  if (result.trouble.empty())
    readResult(workshop.path("result.json"), options.team == "blue", result);
}

}  // namespace

SessionResult runSession(const SessionOptions& options, const StatusLine& status) {
  SessionResult result;
  const Workshop workshop;
  if (workshop.ready())
    play(options, status, workshop, result);
  else
    result.trouble = "cannot make a temporary folder";
  return result;
}

}  // namespace kelpie::cli
