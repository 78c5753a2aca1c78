// SPDX-License-Identifier: Apache-2.0
#include "tools/cli/Session.h"

#include <fmt/core.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string_view>
#include <thread>
#include <vector>

#include "tools/cli/AgentTalk.h"
#include "tools/cli/Logs.h"
#include "tools/cli/Process.h"
#include "tools/cli/Workshop.h"

namespace kelpie::cli {
namespace {

namespace fs = std::filesystem;

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
                                   workshop.path("result.json"),
                                   "--tell-goals"};
  argv.push_back(options.physical ? "--physical" : "--fast");
  if (options.realTime) argv.push_back("--real-time");
  if (!options.log.empty()) {
    argv.insert(argv.end(), {"--truth", workshop.path("world.mcap")});
  }
  for (const auto& artefact : options.artefactsOff) argv.push_back("--no-" + artefact);
  for (const auto& word : wordsOf(options.unlike)) argv.push_back(word);
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
  // Plain: it is compressed when it is joined with the world's.
  if (!options.log.empty())
    argv.insert(argv.end(), {"--plain-log", "--log", workshop.path("agent.mcap")});
  if (options.allImages) argv.push_back("--all-images");
  if (!options.pycode.empty()) argv.insert(argv.end(), {"--pycode", options.pycode});
  if (!options.colourTable.empty())
    argv.insert(argv.end(), {"--colour-table", options.colourTable});
  for (const auto& file : options.params) argv.insert(argv.end(), {"--params", file});
  argv.push_back(options.physical ? "--physical" : "--fast");
  if (!options.driver.empty()) argv.insert(argv.end(), {"--driver", options.driver});
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
  for (const auto& goal : json.value("goals", nlohmann::json::array()))
    (goal.value("team", "") == own ? result.goals : result.ownGoals)
        .push_back(goal.value("t_s", 0.0));
  result.outs = json.value("outs", 0);
  result.seconds = json.value("seconds", 0.0);
}

void tell(const std::string& line, const SessionTalk& talk) {
  if (talk.line)
    talk.line(line);
  else
    fmt::print(stderr, "{}\n", line);
}

// Lines of the world: goals for the caller, anything else (its complaint) for the user.
void hearWorld(const std::string& line, bool blue, const SessionTalk& talk) {
  std::istringstream words(line);
  std::string word;
  std::string team;
  double seconds = 0.0;
  if (!(words >> word >> team >> seconds) || word != "goal")
    tell(line, talk);
  else if (talk.goal)
    talk.goal(team == (blue ? "blue" : "red"), seconds);
}

// What the agent prints: status lines for the caller, its last complaint for the end, the rest (a
// script's error) for the user at once.
struct AgentTalk {
  std::string last;  // what the robot believed; empty before its first frame
  std::string complaint;
  std::vector<std::string> early;  // said before that; a complaint then says all in one line

  std::string when() const { return last.empty() ? "before the first frame" : last; }

  void hear(const std::string& line, const SessionTalk& talk) {
    const std::string_view text = line;
    if (text.substr(0, kStatusMark.size()) == kStatusMark) {
      last = text.substr(kStatusMark.size());
      for (const auto& each : early) tell(each, talk);
      early.clear();
      if (talk.status) talk.status(last);
    } else if (text.substr(0, kComplaintMark.size()) == kComplaintMark) {
      complaint = text.substr(kComplaintMark.size());
    } else if (last.empty()) {
      early.push_back(line);
    } else {
      tell(line, talk);
    }
  }
};

struct Ends {
  int agent = 0;
  int world = 0;
  bool worldAlive = true;  // when the agent had ended
  bool stuck = false;      // the agent had to be killed
};

// Ends a match that is over but for one of its processes: a script inside a long call of Python's
// hears of nothing.
class Patience {
 public:
  // True from five seconds after the first call on.
  bool ended() {
    const auto now = std::chrono::steady_clock::now();
    if (!begun_) since_ = now;
    begun_ = true;
    return now - since_ > std::chrono::seconds(5);
  }

 private:
  bool begun_ = false;
  std::chrono::steady_clock::time_point since_;
};

// Runs until both have ended. The world's death ends the agent (its socket closes); an agent that
// ends in trouble takes the world with it.
Ends waitForBoth(Process& world, Process& agent, bool blue, const SessionTalk& talk,
                 AgentTalk& said) {
  Ends ends;
  std::string line;
  bool asked = false;
  Patience patience;
  while (!agent.ended()) {
    if (agent.readLine(line, 50)) said.hear(line, talk);
    while (world.readLine(line, 0)) hearWorld(line, blue, talk);
    if (!asked && (interrupted() || (talk.over && talk.over()))) {
      asked = true;
      world.terminate();  // it ends the match, and with it the agent
    }
    if ((asked || world.ended()) && !ends.stuck && patience.ended()) {
      ends.stuck = true;
      agent.kill();
    }
  }
  while (agent.readLine(line, 0)) said.hear(line, talk);
  ends.agent = agent.wait();
  // A world that was killed may be a moment behind the agent that its end has stopped.
  for (int i = 0; i < 20 && ends.agent == 1 && !world.ended(); ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  ends.worldAlive = !world.ended();
  if (ends.worldAlive && ends.agent != 0) world.terminate();
  ends.world = world.wait();
  while (world.readLine(line, 0)) hearWorld(line, blue, talk);
  return ends;
}

std::string troubleOf(const Ends& ends, const AgentTalk& said) {
  if (!ends.worldAlive && ends.world >= 128)
    return fmt::format("the world died (signal {}); last: {}", ends.world - 128, said.when());
  if (ends.stuck)
    return "the agent did not answer and was killed (a script in a long call?); last: " +
           said.when();
  if (ends.agent >= 128)
    return fmt::format("the agent died (signal {}); last: {}", ends.agent - 128, said.when());
  if (ends.agent != 0) return said.complaint.empty() ? "the agent gave up" : said.complaint;
  if (ends.world != 0) return fmt::format("the world stopped with code {}", ends.world);
  return {};
}

void watch(Process& world, Process& agent, bool blue, const SessionTalk& talk,
           SessionResult& result) {
  AgentTalk said;
  const Ends ends = waitForBoth(world, agent, blue, talk, said);
  result.trouble = troubleOf(ends, said);
  result.interrupted = interrupted();
  if (result.interrupted && !result.trouble.empty())
    result.trouble = "interrupted; last: " + said.when();
  result.badInput = ends.agent == 2;
}

void play(const SessionOptions& options, const SessionTalk& talk, const Workshop& workshop,
          SessionResult& result) {
  auto world = Process::start(worldCommand(options, workshop), true);
  auto agent = Process::start(agentCommand(options, workshop), true);
  if (!world || !agent) {
    result.trouble = world ? agent.error() : world.error();
    return;
  }
  const bool blue = options.team == "blue";
  watch(*world, *agent, blue, talk, result);
  if (!options.log.empty() && fs::exists(workshop.path("agent.mcap")) && !result.badInput) {
    std::vector<std::string> halves;
    for (const char* half : {"agent.mcap", "world.mcap"})
      if (fs::exists(workshop.path(half))) halves.push_back(workshop.path(half));
    const Status merged = mergeLogs(halves, options.log);
    if (!merged) result.trouble = merged.error();
    result.logged = merged.ok();
  }
  if (result.trouble.empty()) readResult(workshop.path("result.json"), blue, result);
}

}  // namespace

SessionResult runSession(const SessionOptions& options, const SessionTalk& talk) {
  SessionResult result;
  const Workshop workshop;
  if (workshop.ready())
    play(options, talk, workshop, result);
  else
    result.trouble = "cannot make a temporary folder";
  return result;
}

}  // namespace kelpie::cli
