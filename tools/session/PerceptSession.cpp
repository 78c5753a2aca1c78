// SPDX-License-Identifier: Apache-2.0
#include "tools/session/PerceptSession.h"

#include "tools/cli/Process.h"
#include "tools/session/SessionCommands.h"

namespace kelpie::cli {
namespace {

using Words = std::vector<std::string>;

// Of one robot: "--set red:2=KEY=VALUE".
class RobotWords {
 public:
  RobotWords(const std::string& team, int player, Words& argv)
      : name_(team + ":" + std::to_string(player)), argv_(argv) {
    argv_.insert(argv_.end(), {"--robot", name_});
  }
  void add(const char* option, const std::string& value) {
    if (!value.empty()) argv_.insert(argv_.end(), {option, name_ + "=" + value});
  }
  void addEach(const char* option, const Words& values) {
    for (const std::string& value : values) add(option, value);
  }

 private:
  std::string name_;
  Words& argv_;
};

// What needs images, a clock or processes of their own.
const char* lackOf(const SessionOptions& options) {
  if (!options.driver.empty()) return "no driver";
  if (options.realTime || options.orders || options.live) return "no real time and no studio";
  if (options.controller != 0) return "no game controller";
  if (options.radio == "udp") return "no radio but the world's";
  if (!options.redAgent.empty() || !options.blueAgent.empty()) return "no agents of strangers";
  if (options.respawn) return "no agents that are started again";
  if (options.dropRate > 0.0) return "no images that are lost";
  if (!options.artefactsOff.empty()) return "no camera artefacts";
  if (!options.colourTable.empty()) return "no colours";
  if (options.randomised.seed != 0) return "no randomised bodies and venues";
  return nullptr;
}

}  // namespace

Status mayBePercepts(const SessionOptions& options) {
  const char* const lack = lackOf(options);
  return lack == nullptr
             ? Status(Done{})
             : Status(Error{std::string("a match of percepts (--percepts) has ") + lack});
}

Words perceptCommand(const SessionOptions& options, const RunDirectory& runDirectory) {
  Words argv = {programFolder() + "/kelpie-percepts"};
  addMatch(options, runDirectory, argv);
  RobotWords watched(options.team, options.player, argv);
  watched.add("--pycode", options.pycode);
  watched.addEach("--params", options.params);
  watched.addEach("--set", options.set);
  if (options.keepsLog()) watched.add("--log", agentLog(options, runDirectory, 0));
  bool confined = isConfined(options, options.pycode);
  for (const OtherRobot& robot : options.others) {
    confined = confined || isConfined(options, robot.pycode);
    RobotWords words(robot.team, robot.player, argv);
    words.add("--pycode", robot.pycode);
    words.addEach("--params", robot.params);
    words.addEach("--set", robot.set);
    if (options.keepAll || options.allLogs)
      words.add("--log", otherLog(options, runDirectory, robot));
  }
  if (confined) argv.push_back("--confined");
  return argv;
}

}  // namespace kelpie::cli
