// SPDX-License-Identifier: Apache-2.0
// Which processes a match starts, and with which words.
#include <gtest/gtest.h>

#include <algorithm>

#include "tools/session/SessionCommands.h"

namespace kelpie::cli {
namespace {

using Words = std::vector<std::string>;

// The words after each appearance of that option.
Words valuesOf(const Words& argv, const std::string& option) {
  Words values;
  for (std::size_t i = 0; i + 1 < argv.size(); ++i)
    if (argv[i] == option) values.push_back(argv[i + 1]);
  return values;
}

bool has(const Words& argv, const std::string& word) {
  return std::find(argv.begin(), argv.end(), word) != argv.end();
}

SessionOptions withOpponent() {
  SessionOptions options;
  options.seed = 7;
  options.field = "2004";
  options.physical = false;
  options.params = {"own.toml"};
  options.set = {"behaviour.task.grab=false"};
  options.others = {{"blue", 2, "scripts", {"a.toml", "b.toml"}, {"behaviour.task.player=1"}, 9}};
  return options;
}

TEST(Session, TheWorldWaitsForEveryRobot) {
  const RunDirectory runDirectory;
  EXPECT_EQ(valuesOf(worldCommand({}, runDirectory), "--robots"), Words{"1"});
  EXPECT_EQ(valuesOf(worldCommand(withOpponent(), runDirectory), "--robots"), Words{"2"});
}

TEST(Session, AnOpponentIsItsOwnAgentOnTheMatchsFieldWithoutLogOrStatus) {
  const RunDirectory runDirectory;
  SessionOptions options = withOpponent();
  options.log = "match.mcap";
  const Words argv = otherCommand(options, options.others[0], runDirectory);
  EXPECT_EQ(valuesOf(argv, "--team"), Words{"blue"});
  EXPECT_EQ(valuesOf(argv, "--player"), Words{"2"});
  EXPECT_EQ(valuesOf(argv, "--pycode"), Words{"scripts"});
  EXPECT_EQ(valuesOf(argv, "--params"), (Words{"a.toml", "b.toml"}));
  EXPECT_EQ(valuesOf(argv, "--set"), Words{"behaviour.task.player=1"});
  EXPECT_EQ(valuesOf(argv, "--seed"), Words{"9"});
  EXPECT_EQ(valuesOf(argv, "--field"), Words{"2004"});
  EXPECT_TRUE(has(argv, "--fast"));
  EXPECT_FALSE(has(argv, "--log") || has(argv, "--status"));
}

TEST(Session, TheWatchedRobotHasItsOwnParameters) {
  const RunDirectory runDirectory;
  const Words argv = agentCommand(withOpponent(), runDirectory);
  EXPECT_EQ(valuesOf(argv, "--set"), Words{"behaviour.task.grab=false"});
  EXPECT_EQ(valuesOf(argv, "--params"), Words{"own.toml"});
  EXPECT_TRUE(has(argv, "--status"));
}

TEST(Session, FramesAreKeptWithoutImagesUnlessALogIsWanted) {
  const RunDirectory runDirectory;
  SessionOptions options;
  EXPECT_FALSE(has(agentCommand(options, runDirectory), "--log"));
  EXPECT_FALSE(has(worldCommand(options, runDirectory), "--truth"));
  options.keepFrames = true;
  EXPECT_TRUE(has(agentCommand(options, runDirectory), "--no-images"));
  EXPECT_TRUE(has(worldCommand(options, runDirectory), "--truth"));
  options.log = "match.mcap";
  EXPECT_FALSE(has(agentCommand(options, runDirectory), "--no-images"));
}

TEST(Session, WhatIsStagedReachesTheWorld) {
  const RunDirectory runDirectory;
  SessionOptions options;
  options.staging.places = {{{TeamColour::red, 1}, {{180.0, 100.0}, Angle::deg(90.0)}}};
  options.staging.ball = sim::Ball{{20.0, 30.0}, {}};
  options.staging.throws = {{2.5, {{1.0, 2.0}, {3.0, 4.0}}, host::AgentHello{TeamColour::red, 1}}};
  const Words argv = worldCommand(options, runDirectory);
  EXPECT_EQ(valuesOf(argv, "--place"), Words{"red:1:180,100,90"});
  EXPECT_EQ(valuesOf(argv, "--ball"), Words{"20,30,0,0"});
  EXPECT_EQ(valuesOf(argv, "--throw"), Words{"2.5:1,2,3,4:red:1"});
}

}  // namespace
}  // namespace kelpie::cli
