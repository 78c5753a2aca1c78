// SPDX-License-Identifier: Apache-2.0
// Which robots two teams are.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "tools/session/Teams.h"

namespace kelpie::cli {
namespace {

namespace fs = std::filesystem;

SessionOptions played(const std::string& robots, SessionOptions options = {}) {
  EXPECT_TRUE(useTeams(*teamPlan(robots), options));
  return options;
}

bool keeps(const std::vector<std::string>& set) {
  return std::find(set.begin(), set.end(), "behaviour.task.player=1") != set.end();
}

TEST(Teams, FourAgainstFourAreEightRobotsOfWhichTheSecondRedOneIsWatched) {
  const SessionOptions options = played("4v4");
  EXPECT_EQ(7U, options.others.size());
  EXPECT_EQ("red", options.team);
  EXPECT_EQ(2, options.player);
  EXPECT_FALSE(keeps(options.set));
  EXPECT_TRUE(options.rules);
  EXPECT_EQ("kickoff", options.scenario);
}

TEST(Teams, NumberOneOfEachTeamKeepsTheGoal) {
  const SessionOptions options = played("4v3");
  for (const OtherRobot& robot : options.others) EXPECT_EQ(robot.player == 1, keeps(robot.set));
}

TEST(Teams, AloneARobotPlaysForward) {
  EXPECT_FALSE(keeps(played("1v1").set));
  EXPECT_FALSE(keeps(played("1v1").others[0].set));
  EXPECT_TRUE(played("1v0").others.empty());
}

TEST(Teams, WithoutRobotsOfItsOwnTheOtherTeamIsWatched) {
  EXPECT_EQ("blue", played("0v2").team);
  SessionOptions blue;
  blue.team = "blue";
  EXPECT_EQ("red", played("3v0", blue).team);
}

TEST(Teams, OfStrangersAndKelpiesRobotsOneOfKelpiesIsWatched) {
  SessionOptions strangers;
  strangers.redAgent = "true";
  EXPECT_EQ("blue", played("4v4", strangers).team);
  EXPECT_EQ("red", played("4v0", strangers).team);
  EXPECT_FALSE(played("4v0", strangers).watchesKelpie());
  strangers.blueAgent = "true";
  EXPECT_EQ("red", played("4v4", strangers).team);
}

TEST(Teams, NoTwoRobotsLoseTheSameImages) {
  const SessionOptions options = played("4v4");
  for (const OtherRobot& one : options.others)
    for (const OtherRobot& other : options.others)
      EXPECT_TRUE(&one == &other || one.seed != other.seed);
}

TEST(Teams, WhatIsNoTeamIsRefusedWithOneLine) {
  for (const char* robots : {"", "4", "4v5", "0v0", "4x4", "-1v4", "10v4"})
    EXPECT_FALSE(teamPlan(robots)) << robots;
  EXPECT_EQ("'9v9': teams are written as 4v4, with up to 4 robots a side", teamPlan("9v9").error());
}

TEST(Teams, AFolderGivesBehavioursOrParametersOrBoth) {
  const std::string folder = testing::TempDir() + "/team";
  fs::remove_all(folder);
  fs::create_directories(folder);
  TeamPlan plan = *teamPlan("2v0");
  plan.redFolder = folder;
  SessionOptions options;
  EXPECT_EQ("'" + folder + "': holds neither main.py nor team.toml",
            useTeams(plan, options).error());
  std::ofstream(folder + "/team.toml") << "";
  ASSERT_TRUE(useTeams(plan, options));
  EXPECT_EQ("", options.pycode);
  EXPECT_EQ(std::vector<std::string>{folder + "/team.toml"}, options.params);
  std::ofstream(folder + "/main.py") << "";
  SessionOptions both;
  ASSERT_TRUE(useTeams(plan, both));
  EXPECT_EQ(folder, both.pycode);
  EXPECT_EQ(folder, both.others[0].pycode);
}

}  // namespace
}  // namespace kelpie::cli
