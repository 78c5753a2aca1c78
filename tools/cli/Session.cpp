// SPDX-License-Identifier: Apache-2.0
#include "tools/cli/Session.h"

#include <fmt/core.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <optional>

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

Expected<SessionResult> readResult(const std::string& path) {
  std::ifstream file(path);
  const auto json = nlohmann::json::parse(file, nullptr, false);
  if (!json.is_object()) return Error{"the world left no result"};
  SessionResult result;
  result.goals = json.value("goals", 0);
  result.ownGoals = json.value("own_goals", 0);
  result.outs = json.value("outs", 0);
  result.seconds = json.value("seconds", 0.0);
  if (json.contains("first_goal_s") && json["first_goal_s"].is_number())
    result.firstGoal = json["first_goal_s"].get<double>();
  return result;
}

// Runs until both have ended. The world's death ends the agent (its socket closes) and the other
// way round, so nobody waits for ever.
std::string watch(Process& world, Process& agent, const StatusLine& status) {
  std::string line;
  std::string last = "before the first frame";
  while (!agent.ended()) {
    while (agent.readLine(line, 50)) {
      last = line;
      if (status) status(line);
    }
  }
  const int agentCode = agent.wait();
  const int worldCode = world.wait();
  if (worldCode >= 128)
    return fmt::format("the world died (signal {}); last: {}", worldCode - 128, last);
  if (agentCode >= 128)
    return fmt::format("the agent died (signal {}); last: {}", agentCode - 128, last);
  if (worldCode != 0) return fmt::format("the world stopped with code {}", worldCode);
  if (agentCode != 0) return fmt::format("the agent stopped with code {}", agentCode);
  return {};
}

}  // namespace

Expected<SessionResult> runSession(const SessionOptions& options, const StatusLine& status) {
  const Workshop workshop;
  if (!workshop.ready()) return Error{"cannot make a temporary folder"};
  auto world = Process::start(worldCommand(options, workshop), false);
  if (!world) return Error{world.error()};
  auto agent = Process::start(agentCommand(options, workshop), true);
  if (!agent) return Error{agent.error()};
  const std::string trouble = watch(*world, *agent, status);
  if (!options.log.empty() && fs::exists(workshop.path("agent.mcap"))) {
    const Status merged =
        mergeLogs({workshop.path("agent.mcap"), workshop.path("world.mcap")}, options.log);
    if (!merged) return Error{merged.error()};
  }
  if (!trouble.empty()) return Error{trouble};
  return readResult(workshop.path("result.json"));
}

}  // namespace kelpie::cli
