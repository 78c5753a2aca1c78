// SPDX-License-Identifier: Apache-2.0
// kelpie-percepts: a match without images, world and all agents in one process. What is of one
// robot is said as ROBOT=VALUE, the robot as red:2. `kelpie play --percepts` starts it.
#include <fmt/core.h>

#include <algorithm>
#include <exception>
#include <optional>
#include <utility>

#include "tools/cli/AgentTalk.h"
#include "tools/cli/Process.h"
#include "tools/cli/log/Logs.h"
#include "tools/cli/options/Config.h"
#include "tools/percepts/PerceptMatch.h"
#include "tools/session/Confinement.h"
#include "tools/sim/WorldOptions.h"

namespace kelpie::percepts {
namespace {

struct Options : sim::WorldOptions {
  std::vector<std::string> robots;                     // "red:2"
  std::vector<std::string> pycode, params, set, logs;  // "red:2=VALUE"
  bool confined = false;
};

struct Player {
  host::AgentHello hello;
  std::string name;
  cli::ConfigOptions config;
  std::string scripts = cli::defaultScripts();
  std::string log;
};

bool before(const Player& a, const Player& b) {
  return a.hello.team != b.hello.team ? a.hello.team < b.hello.team
                                      : a.hello.player < b.hello.player;
}

Expected<Player> playerFrom(const std::string& word, const Options& options) {
  const std::size_t colon = word.find(':');
  const std::string team = word.substr(0, colon);
  const std::string number = colon == std::string::npos ? "" : word.substr(colon + 1);
  const bool known = (team == "red" || team == "blue") && number.size() == 1 && number[0] >= '1' &&
                     number[0] <= '4';
  if (!known) return Error{"--robot " + word + ": expected red:1 to blue:4"};
  Player player;
  player.name = word;
  player.hello.team = team == "red" ? TeamColour::red : TeamColour::blue;
  player.hello.player = static_cast<std::uint8_t>(number[0] - '0');
  player.config.field = options.field;
  player.config.team = team;
  player.config.player = player.hello.player;
  player.config.body = options.physical ? cli::Body::physical : cli::Body::fast;
  return player;
}

// Hands each value to its robot.
template <class Give>
Status giveOut(const std::vector<std::string>& words, std::vector<Player>& players, Give give) {
  for (const std::string& word : words) {
    const std::size_t equals = word.find('=');
    const std::string name = word.substr(0, equals);
    const auto player = std::find_if(players.begin(), players.end(),
                                     [&](const Player& p) { return p.name == name; });
    if (equals == std::string::npos || player == players.end())
      return Error{word + ": expected ROBOT=VALUE of a robot that plays"};
    give(*player, word.substr(equals + 1));
  }
  return Done{};
}

Expected<std::vector<Player>> playersOf(const Options& options) {
  std::vector<Player> players;
  for (const std::string& word : options.robots) {
    const auto player = playerFrom(word, options);
    if (!player) return Error{player.error()};
    players.push_back(*player);
  }
  std::sort(players.begin(), players.end(), before);
  const Status given[] = {
      giveOut(options.pycode, players, [](Player& p, const auto& v) { p.scripts = v; }),
      giveOut(options.params, players,
              [](Player& p, const auto& v) { p.config.params.push_back(v); }),
      giveOut(options.set, players, [](Player& p, const auto& v) { p.config.set.push_back(v); }),
      giveOut(options.logs, players, [](Player& p, const auto& v) { p.log = v; })};
  for (const Status& status : given)
    if (!status) return Error{status.error()};
  return players;
}

// The agents, with the logs that are asked for. They see no image, but their logs name the tables.
struct Agents {
  vision::VisionCalibration nominal = vision::nominalCalibration();
  std::vector<MatchRobot> robots;
  std::vector<std::unique_ptr<cli::LogFile>> logs;

  Status close() {
    for (const auto& log : logs) {
      const Status closed = log->close();
      if (!closed) return closed;
    }
    return Done{};
  }
};

// Edits are not looked for: a match takes seconds.
Expected<agent::AgentConfig> configOf(const Player& player,
                                      const vision::VisionCalibration& nominal) {
  const Status scripts = cli::checkScripts(player.scripts);
  if (!scripts) return Error{scripts.error()};
  auto config = cli::makeConfig(player.config, nominal);
  if (config) config->behaviour.reload = false;
  return config;
}

Status addAgent(const Player& player, const Options& options, Agents& agents) {
  auto config = configOf(player, agents.nominal);
  if (!config) return Error{config.error()};
  MatchRobot robot{*config, player.scripts};
  if (!player.log.empty()) {
    auto log = cli::LogFile::create(player.log, robot.config, cli::parameterNotes(player.config),
                                    cli::ImagesKept::none,
                                    options.plainLog ? LogOptions{} : cli::playLogOptions());
    if (!log) return Error{log.error()};
    agents.logs.push_back(std::make_unique<cli::LogFile>(std::move(*log)));
    robot.log = agents.logs.back().get();
  }
  agents.robots.push_back(std::move(robot));
  return Done{};
}

sim::ServerHooks hooksOf(const Options& options, const sim::World& world) {
  sim::ServerHooks hooks;
  if (options.tellGoals) hooks.onEvent = sim::tell;
  hooks.stopped = cli::interrupted;
  if (options.tellTime)
    hooks.beforeStep = [teller = sim::TimeTeller(world)](TimeUs now) mutable { teller(now); };
  return hooks;
}

struct Trouble {
  std::string line;
  int code = 0;
};

// Scripts of all teams run in this process, and may read each other's.
Status confineIfAsked(const Options& options, const std::vector<Player>& players) {
  if (!options.confined) return Done{};
  std::vector<std::string> scripts;
  scripts.reserve(players.size());
  for (const Player& player : players) scripts.push_back(player.scripts);
  const auto lack = cli::confineScripts(scripts);
  if (!lack) return Error{lack.error()};
  if (!lack->empty()) sim::tellLine(*lack);
  return Done{};
}

Trouble play(const Options& options) {
  const auto field = fieldOf(options);
  if (!field) return {field.error(), 2};
  const auto staging = sim::stagingFrom(options.staging);
  if (!staging) return {staging.error(), 2};
  const auto players = playersOf(options);
  if (!players) return {players.error(), 2};
  std::vector<host::AgentHello> hellos;
  Agents agents;
  for (const Player& player : *players) {
    const Status added = addAgent(player, options, agents);
    if (!added) return {added.error(), 2};
    hellos.push_back(player.hello);
  }
  const auto setup = sim::stagedScenario(options.scenario, *field, hellos, options.seed, *staging);
  if (!setup) return {setup.error(), 2};
  std::optional<LogWriter> log;
  const Status logged = openLog(options, log);
  if (!logged) return {logged.error(), 1};
  std::ofstream result;
  const Status opened = openResult(options, result);
  if (!opened) return {opened.error(), 1};
  const Status confined = confineIfAsked(options, *players);
  if (!confined) return {confined.error(), 1};
  sim::World world(worldParams(options), *field, *setup, options.seed);
  PerceptMatch match(world, agents.robots, options.seed, log ? &*log : nullptr,
                     hooksOf(options, world));
  const Status loaded = match.loaded();
  if (!loaded) return {loaded.error(), 2};
  const Status played = match.run();
  if (!played) return {played.error(), 1};
  Status closed = agents.close();
  if (closed && log) closed = log->close();
  if (closed) closed = writeResult(options, world, result);
  return closed ? Trouble{} : Trouble{closed.error(), 1};
}

void describe(cli::CommandLine& app, Options& options) {
  app.option("--robot", options.robots, "a robot that plays, as red:2").required();
  app.option("--pycode", options.pycode, "ROBOT=FOLDER of behaviours, or a zip");
  app.option("--params", options.params, "ROBOT=FILE of parameters");
  app.option("--set", options.set, "ROBOT=KEY=VALUE, over the files'");
  app.option("--log", options.logs, "ROBOT=FILE for what it knew, decided and did");
  app.flag("--confined", options.confined,
           "Some scripts are somebody else's: no files but behaviours, no sockets, programs or "
           "memory without end");
  sim::addWorldOptions(app, options);
}

}  // namespace
}  // namespace kelpie::percepts

int main(int argc, char** argv) {
  kelpie::cli::useTargetMaths(argv);
  kelpie::percepts::Options options;
  kelpie::cli::ProgramLine app("A simulated match without images, agents and all",
                               "kelpie-percepts");
  kelpie::percepts::describe(app, options);
  bool done = false;
  const int usage = kelpie::cli::parseOptions(app, argc, argv, done);
  if (done) return usage;
  kelpie::cli::catchInterrupts();
  try {
    const kelpie::percepts::Trouble trouble = kelpie::percepts::play(options);
    if (trouble.code != 0) fmt::print(stderr, "kelpie-percepts: {}\n", trouble.line);
    return trouble.code;
  } catch (const std::exception& error) {
    fmt::print(stderr, "kelpie-percepts: {}\n", error.what());
    return 2;
  }
}
