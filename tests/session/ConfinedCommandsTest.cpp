// SPDX-License-Identifier: Apache-2.0
// Which processes of a match are started confined: those of teams from elsewhere, as `kelpie play
// --red --blue --pycode` and `kelpie league` make them of folders.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "tests/session/OwnFolder.h"
#include "tools/session/PerceptSession.h"
#include "tools/session/SessionCommands.h"
#include "tools/session/Teams.h"

namespace kelpie::cli {
namespace {

namespace fs = std::filesystem;

using Words = std::vector<std::string>;

bool isTold(const Words& argv) {
  return std::find(argv.begin(), argv.end(), "--confined") != argv.end();
}

class ConfinedCommands : public testing::Test {
 protected:
  void SetUp() override {
    std::string name = "/tmp/kelpie-foxes-XXXXXX";
    foxes_ = ::mkdtemp(name.data());
    std::ofstream(foxes_ + "/main.py") << "text";
  }
  void TearDown() override { fs::remove_all(foxes_); }

  static SessionOptions match(const std::string& red, const std::string& blue,
                              SessionOptions options = {}) {
    TeamPlan plan = *teamPlan("2v2");
    plan.redFolder = red;
    plan.blueFolder = blue;
    EXPECT_TRUE(useTeams(plan, options));
    return options;
  }
  // The robots whose agents are told, in whichever of their lives.
  Words confinedOf(const SessionOptions& options, int life = 0) const {
    Words names;
    if (isTold(agentCommand(options, runDirectory_, life)))
      names.push_back(options.team + " " + std::to_string(options.player));
    for (const OtherRobot& robot : options.others)
      if (isTold(otherCommand(options, robot, runDirectory_, life)))
        names.push_back(robot.team + " " + std::to_string(robot.player));
    std::sort(names.begin(), names.end());
    return names;
  }
  bool perceptsAreTold(const SessionOptions& options) const {
    return isTold(perceptCommand(options, runDirectory_));
  }

  std::string foxes_;
  std::string own_ = ownFolder() + "/teams/runner";  // Kelpie's own that has scripts
  RunDirectory runDirectory_;
};

TEST_F(ConfinedCommands, OnlyTheStrangersOfAMatchAreConfined) {
  EXPECT_EQ(confinedOf(match(own_, foxes_)), (Words{"blue 1", "blue 2"}));
  EXPECT_EQ(confinedOf(match(foxes_, own_)), (Words{"red 1", "red 2"}));
  EXPECT_EQ(confinedOf(match("", foxes_)), (Words{"blue 1", "blue 2"}));
  EXPECT_EQ(confinedOf(match(foxes_, foxes_)).size(), 4U);
  EXPECT_EQ(confinedOf(match(own_, "")), Words{});
}

TEST_F(ConfinedCommands, SoAreThoseThatAreStartedAgain) {
  EXPECT_EQ(confinedOf(match(foxes_, own_), 1), (Words{"red 1", "red 2"}));
}

TEST_F(ConfinedCommands, ScriptsForAllRobotsAreThoseOfEachWithoutAFolder) {
  SessionOptions options;
  options.pycode = foxes_;
  EXPECT_EQ(confinedOf(options), Words{"red 1"});
  EXPECT_EQ(confinedOf(match("", own_, options)), (Words{"red 1", "red 2"}));
}

TEST_F(ConfinedCommands, AMatchOfPerceptsIsConfinedForAnyStranger) {
  EXPECT_TRUE(perceptsAreTold(match(own_, foxes_)));
  EXPECT_TRUE(perceptsAreTold(match(foxes_, own_)));
  EXPECT_TRUE(perceptsAreTold(match(foxes_, foxes_)));
  EXPECT_FALSE(perceptsAreTold(match(own_, "")));
}

TEST_F(ConfinedCommands, WhoIsTrustedIsNotConfined) {
  SessionOptions trusted;
  trusted.trust = true;
  EXPECT_EQ(confinedOf(match(foxes_, foxes_, trusted)), Words{});
  EXPECT_FALSE(perceptsAreTold(match(foxes_, foxes_, trusted)));
}

}  // namespace
}  // namespace kelpie::cli
