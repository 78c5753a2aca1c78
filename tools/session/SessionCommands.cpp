// SPDX-License-Identifier: Apache-2.0
#include "tools/session/SessionCommands.h"

#include <algorithm>
#include <filesystem>

#include "tools/cli/DataFolder.h"
#include "tools/cli/Process.h"
#include "tools/session/Teams.h"

namespace kelpie::cli {
namespace {

namespace fs = std::filesystem;

using Words = std::vector<std::string>;

void addEach(const char* option, const Words& values, Words& argv) {
  for (const auto& value : values) argv.insert(argv.end(), {option, value});
}

void addUnlessEmpty(const char* option, const std::string& value, Words& argv) {
  if (!value.empty()) argv.insert(argv.end(), {option, value});
}

void addStaging(const sim::Staging& staging, Words& argv) {
  for (const auto& place : staging.places)
    argv.insert(argv.end(), {"--place", sim::wordsFor(place)});
  if (staging.ball) argv.insert(argv.end(), {"--ball", sim::wordsFor(*staging.ball)});
  for (const auto& thrown : staging.throws)
    argv.insert(argv.end(), {"--throw", sim::wordsFor(thrown)});
  for (const auto& take : staging.takes)
    argv.insert(argv.end(), {"--take-ball", sim::wordsFor(take)});
  for (const auto& carry : staging.carries)
    argv.insert(argv.end(), {"--carry", sim::wordsFor(carry)});
  for (const auto& robot : staging.deaf) argv.insert(argv.end(), {"--deaf", sim::wordsFor(robot)});
}

// What every agent of a match has in common.
Words anyAgent(const SessionOptions& options, const std::string& team, std::uint64_t seed,
               const RunDirectory& runDirectory, int life) {
  Words argv = {programFolder() + "/kelpie-agent",
                "--socket",
                runDirectory.path("world"),
                "--team",
                team,
                "--field",
                options.field,
                "--ring",
                options.ring,
                "--drop-rate",
                std::to_string(options.dropRate),
                "--seed",
                std::to_string(seed),
                "--radio",
                options.radio == "udp" ? "udp" : "world",
                options.physical ? "--physical" : "--fast"};
  addUnlessEmpty("--colour-table", options.colourTable, argv);
  if (options.orders) argv.push_back("--patient");
  if (life > 0) argv.push_back("--again");
  return argv;
}

}  // namespace

std::vector<host::AgentHello> strangersOf(const SessionOptions& options) {
  std::vector<host::AgentHello> robots = robotsOf(options);
  const auto isKelpie = [&](const host::AgentHello& robot) {
    return (robot.team == TeamColour::red ? options.redAgent : options.blueAgent).empty();
  };
  robots.erase(std::remove_if(robots.begin(), robots.end(), isKelpie), robots.end());
  return robots;
}

std::string strangerSocket(const host::AgentHello& robot, const RunDirectory& runDirectory) {
  std::string name = "world-" + sim::nameOf(robot);
  std::replace(name.begin(), name.end(), ' ', '-');
  return runDirectory.path(name.c_str());
}

Words strangerCommand(const SessionOptions& options, const host::AgentHello& robot,
                      const RunDirectory& runDirectory) {
  const std::string team = robot.team == TeamColour::red ? "red" : "blue";
  return {"/usr/bin/env",
          "-u",
          "GLIBC_TUNABLES",  // of Kelpie's own programs (Process.h, useTargetMaths)
          "KELPIE_SOCKET=" + strangerSocket(robot, runDirectory),
          "KELPIE_TEAM=" + team,
          "KELPIE_PLAYER=" + std::to_string(robot.player),
          "/bin/sh",
          "-c",
          options.strangerOf(team)};
}

Words worldCommand(const SessionOptions& options, const RunDirectory& runDirectory) {
  const std::vector<host::AgentHello> strangers = strangersOf(options);
  Words argv = {programFolder() + "/kelpie-world", "--socket", runDirectory.path("world"),
                "--robots", std::to_string(1 + options.others.size() - strangers.size())};
  for (const host::AgentHello& robot : strangers)
    argv.insert(argv.end(), {"--stranger", sim::wordsFor(robot)});
  if (!strangers.empty())
    argv.insert(argv.end(), {"--agent-limit", std::to_string(options.agentLimit), "--agent-wait",
                             std::to_string(options.agentWait)});
  addMatch(options, runDirectory, argv);
  if (options.controller != 0)
    argv.insert(argv.end(), {"--game-controller", std::to_string(options.controller)});
  argv.push_back("--respawn");  // who may come again is the session's to say
  if (options.realTime) argv.push_back("--real-time");
  if (options.orders) argv.push_back("--orders");
  for (const auto& artefact : options.artefactsOff) argv.push_back("--no-" + artefact);
  return argv;
}

void addMatch(const SessionOptions& options, const RunDirectory& runDirectory, Words& argv) {
  argv.insert(argv.end(),
              {"--seed", std::to_string(options.seed), "--field", options.field, "--scenario",
               options.scenario, "--seconds", std::to_string(options.seconds), "--goals",
               std::to_string(options.goals), "--result", runDirectory.path("result.json"),
               "--tell-goals", options.physical ? "--physical" : "--fast"});
  const double loss = options.radio == "none" ? 1.0 : options.radioLoss;
  if (loss >= 0.0) argv.insert(argv.end(), {"--radio-loss", std::to_string(loss)});
  if (options.radioDelay >= 0.0)
    argv.insert(argv.end(), {"--radio-delay", std::to_string(options.radioDelay)});
  addEach("--note", options.notes, argv);
  if (options.rules) argv.insert(argv.end(), {"--rules", "--tell-time"});
  if (options.fromPlay) argv.push_back("--from-play");
  if (options.holdingDistance > 0.0)
    argv.insert(argv.end(), {"--holding-distance", std::to_string(options.holdingDistance)});
  if (options.live) argv.push_back("--plain-log");
  if (options.keepsLog() || options.keepTruth)
    argv.insert(argv.end(), {"--truth", partPath(options, runDirectory, "world.mcap")});
  for (const auto& word : wordsOf(options.randomised)) argv.push_back(word);
  addStaging(options.staging, argv);
}

// A log that is kept is written where it is kept: a match that is killed leaves it there.
std::string partPath(const SessionOptions& options, const RunDirectory& runDirectory,
                     const std::string& name) {
  if (options.log.empty()) return runDirectory.path(name.c_str());
  return (fs::path(options.log).parent_path() / "playing" / name).string();
}

std::string agentLog(const SessionOptions& options, const RunDirectory& runDirectory, int life) {
  const std::string stem = options.log.empty() ? "agent" : fs::path(options.log).stem().string();
  const std::string number = life == 0 ? "" : "-" + std::to_string(life + 1);
  return partPath(options, runDirectory, stem + number + ".mcap");
}

std::string logName(const std::string& team, int player, int life) {
  const std::string number = life == 0 ? "" : "-" + std::to_string(life + 1);
  return team + "-" + std::to_string(player) + number + ".mcap";
}

std::string otherLog(const SessionOptions& options, const RunDirectory& runDirectory,
                     const OtherRobot& robot, int life) {
  return partPath(options, runDirectory, logName(robot.team, robot.player, life));
}

bool isConfined(const SessionOptions& options, const std::string& scripts) {
  if (options.trust || scripts.empty()) return false;
  std::error_code error;
  const fs::path place = fs::weakly_canonical(scripts, error).lexically_relative(dataFolder());
  return error || place.empty() || *place.begin() == "..";
}

namespace {

// `robot`: the session itself for the one that is watched, or an OtherRobot.
template <class Robot>
void addBehaviours(const SessionOptions& options, const Robot& robot, Words& argv) {
  addUnlessEmpty("--pycode", robot.pycode, argv);
  if (isConfined(options, robot.pycode)) argv.push_back("--confined");
  addEach("--params", robot.params, argv);
  addEach("--set", robot.set, argv);
}

}  // namespace

Words agentCommand(const SessionOptions& options, const RunDirectory& runDirectory, int life) {
  Words argv = anyAgent(options, options.team, options.seed, runDirectory, life);
  argv.insert(argv.end(), {"--player", std::to_string(options.player), "--status"});
  // Plain: it is compressed when it is joined with the world's.
  if (options.keepsLog())
    argv.insert(argv.end(), {"--plain-log", "--log", agentLog(options, runDirectory, life)});
  if (options.log.empty() && options.keepsLog())
    argv.push_back("--no-images");
  else if (options.images == ImagesKept::planes)
    argv.push_back("--planes");
  else if (options.images == ImagesKept::all)
    argv.push_back("--all-images");
  addBehaviours(options, options, argv);
  addUnlessEmpty("--driver", options.driver, argv);
  return argv;
}

Words otherCommand(const SessionOptions& options, const OtherRobot& robot,
                   const RunDirectory& runDirectory, int life) {
  Words argv = anyAgent(options, robot.team, robot.seed, runDirectory, life);
  argv.insert(argv.end(), {"--player", std::to_string(robot.player)});
  if (options.keepAll || options.allLogs)
    argv.insert(argv.end(), {options.keepAll ? "--no-images" : "--planes", "--log",
                             otherLog(options, runDirectory, robot, life)});
  if (options.live) argv.push_back("--plain-log");
  addBehaviours(options, robot, argv);
  return argv;
}

}  // namespace kelpie::cli
