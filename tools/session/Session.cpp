// SPDX-License-Identifier: Apache-2.0
#include "tools/session/Session.h"

#include <fmt/core.h>

#include <array>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <optional>
#include <sstream>
#include <string_view>
#include <thread>
#include <vector>

#include "behaviour/watch/HungExit.h"
#include "tools/cli/AgentTalk.h"
#include "tools/cli/Process.h"
#include "tools/cli/RunDirectory.h"
#include "tools/session/MatchFolder.h"
#include "tools/session/Others.h"
#include "tools/session/PerceptSession.h"
#include "tools/session/SessionCommands.h"
#include "tools/session/Strangers.h"

namespace kelpie::cli {
namespace {

namespace fs = std::filesystem;

void readResult(const std::string& path, bool blue, SessionResult& result) {
  std::ifstream file(path);
  const auto json = nlohmann::json::parse(file, nullptr, false);
  if (!json.is_object()) {
    result.trouble = "the world left no result";
    return;
  }
  const std::string own = blue ? "blue" : "red";
  for (const auto& goal : json.value("goals", nlohmann::json::array())) {
    (goal.value("team", "") == own ? result.goals : result.ownGoals)
        .push_back(goal.value("t_s", 0.0));
    if (goal.value("own", false))
      ++(goal.value("team", "") == "red" ? result.blueOwnGoals : result.redOwnGoals);
  }
  result.outs = json.value("outs", 0);
  result.seconds = json.value("seconds", 0.0);
}

void tell(const std::string& line, const SessionTalk& talk) {
  if (talk.line)
    talk.line(line);
  else
    fmt::print(stderr, "{}\n", line);
}

// "time 12.5 playing 1 290 0 1": simulated seconds, state, half, seconds of it left, score.
bool hearTime(const std::string& line, const SessionTalk& talk) {
  std::istringstream words(line);
  std::string word;
  MatchTime now;
  int half = 1;
  if (!(words >> word >> now.seconds >> now.state >> half >> now.left >> now.red >> now.blue) ||
      word != "time")
    return false;
  now.firstHalf = half == 1;
  if (talk.time) talk.time(now);
  return true;
}

// What the world prints: goals and the time for the caller, its complaint for the end.
struct WorldTalk {
  bool blue = false;  // the team that is watched
  std::string complaint;

  void hear(const std::string& line, const SessionTalk& talk) {
    constexpr std::array<std::string_view, 2> kMarks{"kelpie-world: ", "kelpie-percepts: "};
    std::istringstream words(line);
    std::string word;
    std::string team;
    double seconds = 0.0;
    if (hearTime(line, talk)) return;
    for (const std::string_view mark : kMarks)
      if (line.compare(0, mark.size(), mark) == 0) {
        complaint = line.substr(mark.size());
        return;
      }
    if (!(words >> word >> team >> seconds) || word != "goal")
      tell(line, talk);
    else if (talk.goal)
      talk.goal(team == (blue ? "blue" : "red"), seconds);
  }
};

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
  bool busy = false;       // it was computing then
  bool stopped = false;    // a signal held it then
  bool other = false;      // another robot ended in trouble of its own
};

// The processes of a match, and what they said.
struct Processes {
  const SessionOptions& options;
  const RunDirectory& runDirectory;
  Process& world;
  std::optional<Process>& agent;  // of the robot that is watched; none: it is a stranger's
  Others& others;
  Strangers& strangers;
  int life = 0;  // of the agent
  WorldTalk worldSaid;
  AgentTalk agentSaid;
};

// Ends a match that is over but for one of its processes: a script inside a long call of Python's
// hears of nothing.
class Patience {
 public:
  // True from five seconds after the first call on.
  bool ended(const Process& agent) {
    const auto now = std::chrono::steady_clock::now();
    if (!begun_) since_ = now;
    if (!begun_) computed_ = agent.computed();
    begun_ = true;
    return now - since_ > std::chrono::seconds(5);
  }
  // More than an agent that waits or is about to end does.
  bool wasBusy(const Process& agent) const { return agent.computed() - computed_ > 1.0; }

 private:
  bool begun_ = false;
  double computed_ = 0.0;  // s, by the agent until the first call
  std::chrono::steady_clock::time_point since_;
};

// Whether the world has ended, or does within a fifth of a second: one that was killed may be a
// moment behind the agents that its end has stopped.
bool endsSoon(Process& world) {
  for (int i = 0; i < 20 && !world.ended(); ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  return world.ended();
}

void hearAll(int milliseconds, const SessionTalk& talk, Processes& processes) {
  std::string line;
  if (processes.agent && processes.agent->readLine(line, milliseconds))
    processes.agentSaid.hear(line, talk);
  for (int wait = processes.agent ? 0 : milliseconds; processes.world.readLine(line, wait);
       wait = 0)
    processes.worldSaid.hear(line, talk);
  processes.others.hear([&](const std::string& said) { tell(said, talk); });
  if (!talk.orders) return;
  for (std::string order = talk.orders(); !order.empty(); order = talk.orders())
    if (!processes.world.say(order)) tell("the world does not hear '" + order + "'", talk);
}

// Another robot that ends in trouble takes the match with it: the world may still wait for it. One
// that gives up while the world ends has lost that world only.
void watchOthers(const SessionTalk& talk, Processes& processes, Ends& ends) {
  if (ends.other || !processes.others.failed()) return;
  if (processes.others.gaveUp() && endsSoon(processes.world)) return;
  const std::string trouble = processes.others.trouble();
  const bool may = processes.options.respawn || processes.others.hung();
  const bool again = may && !processes.others.badInput() && !processes.world.ended();
  if (again && processes.others.revive()) return tell(trouble + "; it is started again", talk);
  ends.other = true;
  processes.world.terminate();
}

// What a dead agent has said last. One whose script hung as it loaded had no more time for
// a complaint.
void hearLast(int code, const SessionTalk& talk, Processes& processes) {
  AgentTalk& said = processes.agentSaid;
  std::string line = "a script does not end while it loads";
  while (processes.agent->readLine(line, 0)) said.hear(line, talk);
  if (code == behaviour::kHungLoadExit && said.complaint.empty())
    said.complaint = said.early.empty() ? line : said.early.back();
}

// Starts the watched agent again if it died while the match goes on; after a script that hung
// also without being asked to.
bool reviveAgent(const SessionTalk& talk, Processes& processes) {
  if (!processes.agent) return false;
  const int code = processes.agent->wait();
  hearLast(code, talk, processes);
  const bool may = processes.options.respawn || code == behaviour::kHungExit;
  if (!may || processes.life + 1 >= kMaxLives || interrupted()) return false;
  if (code == 0 || code == 2 || endsSoon(processes.world)) return false;
  const auto command = agentCommand(processes.options, processes.runDirectory, processes.life + 1);
  auto process = Process::start(command, true);
  if (!process) return false;
  ++processes.life;
  processes.agent.emplace(std::move(*process));
  tell(fmt::format("the agent ended with code {}; it is started again", code), talk);
  return true;
}

// Runs until agent and world have ended. The world's death ends the agents (their sockets close);
// an agent that ends in trouble takes the world with it.
Ends waitForAll(const SessionTalk& talk, Processes& processes) {
  Ends ends;
  bool asked = false;
  Patience patience;
  Process& last = processes.agent ? *processes.agent : processes.world;
  while (!last.ended() || reviveAgent(talk, processes)) {
    hearAll(50, talk, processes);
    watchOthers(talk, processes, ends);
    processes.strangers.watch([&](const std::string& said) { tell(said, talk); });
    if (!asked && (interrupted() || (talk.over && talk.over()))) {
      asked = true;
      processes.world.terminate();  // it ends the match, and with it the agents
    }
    if ((asked || processes.world.ended()) && !ends.stuck && patience.ended(last)) {
      ends.stuck = true;
      ends.busy = patience.wasBusy(last);
      ends.stopped = last.stopped();
      last.kill();
      processes.others.kill();
    }
  }
  ends.agent = processes.agent ? processes.agent->wait() : 0;
  if (ends.agent == 1) watchOthers(talk, processes, ends);
  ends.worldAlive = ends.agent == 1 ? !endsSoon(processes.world) : !processes.world.ended();
  if (ends.worldAlive && ends.agent != 0) processes.world.terminate();
  ends.world = processes.world.wait();
  std::string line;
  while (processes.agent && processes.agent->readLine(line, 0))
    processes.agentSaid.hear(line, talk);
  hearAll(0, talk, processes);
  processes.strangers.end();
  return ends;
}

// A script is blamed only where one is asked in each frame and the agent computed on and on.
std::string stuckHow(const Ends& ends, const Processes& processes) {
  if (!processes.agent) return "the world did not end and was killed";
  if (ends.stopped) return "the agent was stopped by a signal, and was killed";
  if (processes.agentSaid.last.empty()) return "the agent had not begun to play and was killed";
  const bool script = ends.busy && processes.options.driver.empty();
  return std::string("the agent did not answer and was killed") +
         (script ? " (a script in a long call?)" : "");
}

// Who ends last has often only lost the others: the first cause is reported.
std::string troubleOf(const Ends& ends, const Processes& processes) {
  const std::string when = "; last: " + processes.agentSaid.when();
  if (!ends.worldAlive && ends.world >= 128)
    return fmt::format("the world died (signal {})", ends.world - 128) + when;
  if (ends.other) return processes.others.trouble() + when;
  if (ends.stuck) return stuckHow(ends, processes) + when;
  if (ends.agent >= 128) return fmt::format("the agent died (signal {})", ends.agent - 128) + when;
  if (ends.agent == 2) return processes.agentSaid.complaint;
  if (!processes.worldSaid.complaint.empty()) return processes.worldSaid.complaint;
  if (ends.agent != 0)
    return processes.agentSaid.complaint.empty() ? "the agent gave up"
                                                 : processes.agentSaid.complaint;
  if (ends.world != 0) return fmt::format("the world stopped with code {}", ends.world);
  return {};
}

void watch(const SessionTalk& talk, Processes& processes, SessionResult& result) {
  const Ends ends = waitForAll(talk, processes);
  result.trouble = troubleOf(ends, processes);
  result.interrupted = interrupted();
  if (result.interrupted && !result.trouble.empty())
    result.trouble = "interrupted; last: " + processes.agentSaid.when();
  result.badInput = ends.agent == 2 || (ends.other && processes.others.badInput());
}

void keepLog(const SessionOptions& options, const SessionTalk& talk, SessionResult& result) {
  if (options.log.empty()) return;
  const std::string folder = fs::path(options.log).parent_path().string();
  if (result.badInput) return forgetParts(folder);
  const Status ready = talk.logs ? talk.logs() : Status(Done{});
  const auto join = [&] {
    return options.watchesKelpie() ? joinParts(folder) : joinWithoutWatched(folder, options.log);
  };
  const auto joined = ready ? join() : Expected<std::vector<JoinedLog>>(Error{ready.error()});
  if (joined) {
    for (const JoinedLog& log : *joined) result.logs.push_back(log.path);
    if (joined->empty()) result.logTrouble = folder + "/playing: its logs are gone";
    std::error_code error;
    result.logged = fs::exists(options.log, error);
  } else {
    const std::string& why = result.logTrouble.empty() ? joined.error() : result.logTrouble;
    result.logTrouble = why + "; `kelpie recover " + folder + "` joins what is in " + folder +
                        "/playing when there is room";
  }
}

// Lines on their way to the user, of which one may say that a log ended.
SessionTalk watchLogs(const SessionOptions& options, const SessionTalk& talk,
                      SessionResult& result) {
  SessionTalk watched = talk;
  watched.line = [&](const std::string& line) {
    const bool ends = line.find(kLogEndsMark) != std::string::npos;
    if (ends && result.logTrouble.empty()) result.logTrouble = line;
    tell(line, talk);
  };
  watched.over = [&] {
    return (options.endWithLog && !result.logTrouble.empty()) || (talk.over && talk.over());
  };
  return watched;
}

// What was played, for the caller.
void handOn(const SessionOptions& options, const SessionTalk& talk,
            const RunDirectory& runDirectory, SessionResult& result) {
  keepLog(options, talk, result);
  if (!result.trouble.empty()) return;
  readResult(runDirectory.path("result.json"), options.team == "blue", result);
  if (talk.frames && (options.keepFrames || options.keepTruth))
    talk.frames(agentLog(options, runDirectory, 0), runDirectory.path("world.mcap"));
  if (!talk.all || !options.keepAll) return;
  std::vector<std::string> logs = {agentLog(options, runDirectory, 0)};
  for (const OtherRobot& robot : options.others)
    logs.push_back(otherLog(options, runDirectory, robot));
  talk.all(logs, runDirectory.path("world.mcap"));
}

// World and agents are one process.
void playPercepts(const SessionOptions& options, const SessionTalk& talk,
                  const RunDirectory& runDirectory, SessionResult& result) {
  const Status fits = mayBePercepts(options);
  auto match = fits ? Process::start(perceptCommand(options, runDirectory), true)
                    : Expected<Process>(Error{fits.error()});
  if (!match) {
    result.trouble = match.error();
    result.badInput = !fits;
    return;
  }
  WorldTalk said{options.team == "blue", {}};
  std::string line;
  bool asked = false;
  while (!match->ended()) {
    if (match->readLine(line, 50)) said.hear(line, talk);
    if (asked || !(interrupted() || (talk.over && talk.over()))) continue;
    asked = true;
    match->terminate();
  }
  while (match->readLine(line, 0)) said.hear(line, talk);
  const int code = match->wait();
  result.interrupted = interrupted();
  result.badInput = code == 2;
  if (code >= 128) result.trouble = fmt::format("the match died (signal {})", code - 128);
  if (code > 0 && code < 128)
    result.trouble = said.complaint.empty() ? "the match gave up" : said.complaint;
  handOn(options, talk, runDirectory, result);
}

// Nobody's when it is a stranger that plays the robot.
Expected<std::optional<Process>> watchedAgent(const SessionOptions& options,
                                              const RunDirectory& runDirectory) {
  if (!options.watchesKelpie()) return std::optional<Process>();
  auto agent = Process::start(agentCommand(options, runDirectory), true);
  if (!agent) return Error{agent.error()};
  return std::optional<Process>(std::move(*agent));
}

void play(const SessionOptions& options, const SessionTalk& talk, const RunDirectory& runDirectory,
          SessionResult& result) {
  auto world = Process::start(worldCommand(options, runDirectory), true, options.orders);
  auto agent = watchedAgent(options, runDirectory);
  auto others = Others::start(options, runDirectory);
  if (!world || !agent || !others) {
    result.trouble = !world ? world.error() : !agent ? agent.error() : others.error();
    return;
  }
  Strangers strangers = Strangers::start(options, runDirectory, *world);
  const bool blue = options.team == "blue";
  Processes processes{options, runDirectory, *world, *agent, *others, strangers, 0, {blue, {}}, {}};
  watch(watchLogs(options, talk, result), processes, result);
  handOn(options, talk, runDirectory, result);
}

}  // namespace

SessionResult runSession(const SessionOptions& options, const SessionTalk& talk) {
  SessionResult result;
  const RunDirectory runDirectory;
  if (!runDirectory.ready())
    result.trouble = "cannot make a temporary folder";
  else if (options.percepts)
    playPercepts(options, talk, runDirectory, result);
  else
    play(options, talk, runDirectory, result);
  return result;
}

}  // namespace kelpie::cli
