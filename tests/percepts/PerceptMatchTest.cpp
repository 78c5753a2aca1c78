// SPDX-License-Identifier: Apache-2.0
// Agents of one process play by behaviours of their own, and one seed gives one match.
#include <gtest/gtest.h>

#include "tests/behaviour/Scripts.h"
#include "tools/percepts/PerceptMatch.h"
#include "tools/sim/bodies/FastActuator.h"
#include "tools/sim/staging/Staging.h"

namespace kelpie::percepts {
namespace {

using behaviour::Scripts;

// What a match came to.
class Played : public agent::LogSink {
 public:
  void frame(const FrameInput& input, const FrameOutput& output) override {
    if (output.command.fallback != Fallback::none) ++fallbacks;
    forward[input.game.team == TeamColour::red ? 0 : 1] = output.command.walk.forward;
    seen += output.percepts.ball.present ? 1 : 0;
  }

  double forward[2] = {0.0, 0.0};  // asked last, of red and blue
  int fallbacks = 0;
  int seen = 0;
  std::vector<Pose2> ends;
  Status status = Done{};
};

MatchRobot robotOf(TeamColour team, std::uint8_t player, const std::string& scripts, Played& log) {
  MatchRobot robot;
  robot.config.field = *body::fieldDescription("2006");
  robot.config.team = team;
  robot.config.player = player;
  robot.config.calibration = vision::nominalCalibration();
  sim::makeFast({}, robot.config.actuator);
  agent::shareField(robot.config);
  robot.scripts = scripts;
  robot.log = &log;
  return robot;
}

// Two against two for twelve seconds, by the simple referee.
Played play(const std::string& red, const std::string& blue, std::uint64_t seed) {
  Played played;
  std::vector<MatchRobot> robots;
  std::vector<host::AgentHello> hellos;
  for (const TeamColour team : {TeamColour::red, TeamColour::blue})
    for (std::uint8_t player = 1; player <= 2; ++player) {
      robots.push_back(robotOf(team, player, team == TeamColour::red ? red : blue, played));
      hellos.push_back({team, player});
    }
  const body::FieldDescription field = *body::fieldDescription("2006");
  sim::WorldParams params;
  params.referee.seconds = 12.0;
  sim::World world(params, field, *sim::scenario("kickoff", field, hellos, seed), seed);
  PerceptMatch match(world, robots, seed, nullptr);
  played.status = match.run();
  for (const auto& robot : world.truth(world.time()).robots) played.ends.push_back(robot.pose);
  return played;
}

constexpr const char* kPycode = KELPIE_SOURCE_DIR "/pycode";

TEST(PerceptMatch, TheSameSeedGivesTheSameMatchBitForBit) {
  const Played one = play(kPycode, kPycode, 3);
  const Played two = play(kPycode, kPycode, 3);
  ASSERT_TRUE(one.status) << one.status.error();
  ASSERT_EQ(4U, one.ends.size());
  EXPECT_EQ(0, one.fallbacks);
  EXPECT_GT(one.seen, 200);
  EXPECT_EQ(one.seen, two.seen);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(one.ends[i].position.x, two.ends[i].position.x);
    EXPECT_EQ(one.ends[i].position.y, two.ends[i].position.y);
  }
}

TEST(PerceptMatch, EachTeamPlaysByItsOwnFolder) {
  const Scripts red("return kelpie.Command(walk=kelpie.WalkRequest(forward=7.0))");
  const Scripts blue("return kelpie.Command(walk=kelpie.WalkRequest(forward=-5.0))");
  const Played played = play(red.path(), blue.path(), 1);
  ASSERT_TRUE(played.status) << played.status.error();
  EXPECT_EQ(7.0, played.forward[0]);
  EXPECT_EQ(-5.0, played.forward[1]);
}

TEST(PerceptMatch, AScriptThatDoesNotLoadIsNamedBeforeTheMatch) {
  const Scripts good("return kelpie.Command()");
  const Scripts bad;
  bad.write("main.py", "def decide(world)\n    return 1\n");
  const Played played = play(good.path(), bad.path(), 1);
  ASSERT_FALSE(played.status);
  EXPECT_NE(std::string::npos, played.status.error().find("main.py:1"));
}

}  // namespace
}  // namespace kelpie::percepts
