// SPDX-License-Identifier: Apache-2.0
// The world does what its referee asks, with the rules and without.
#include <gtest/gtest.h>

#include "tests/sim/rules/Scenes.h"
#include "tools/sim/world/World.h"

namespace kelpie::sim {
namespace {

const std::vector<host::AgentHello> kTwo{{kRed, 2}, {kBlue, 2}};

struct Played {
  explicit Played(bool rules) : params(with(rules)), world(params, field, start(), 3) {}

  static WorldParams with(bool rules) {
    WorldParams params;
    params.referee.rules = rules;
    params.spectators = false;
    return params;
  }
  // Robots that get no commands stay where they are.
  static Setup start() { return *scenario("kickoff", ruleField(), kTwo, 3); }
  bool until(PlayState state) {
    for (int i = 0; i < 10000 && world.gameFor(0).state != state; ++i) world.tick();
    return world.gameFor(0).state == state;
  }
  void goOn(double seconds) {
    for (int i = 0; i * kTickSeconds < seconds; ++i) world.tick();
  }
  Pose2 pose(std::size_t robot) { return world.bodies().place(robot).pose; }

  body::FieldDescription field = ruleField();
  WorldParams params;
  World world;
};

TEST(RuledWorld, WithoutRulesTheBallIsInPlayFromTheFirstTickAndNobodyIsMoved) {
  Played match(false);
  EXPECT_EQ(match.world.gameFor(0).state, PlayState::playing);
  EXPECT_EQ(match.world.control().state, PlayState::playing);
  match.world.carry(0, {{-40.0, 200.0}, Angle()});
  match.goOn(2.0);
  EXPECT_FALSE(match.world.gameFor(0).penalised);
  EXPECT_NEAR(match.pose(0).position.x, -40.0, 1.0);
  ASSERT_EQ(match.world.takeEvents().size(), 1U);
}

TEST(RuledWorld, TheStatesBeginWithInitialAndComeToPlay) {
  Played match(true);
  EXPECT_EQ(match.world.gameFor(0).state, PlayState::initial);
  ASSERT_TRUE(match.until(PlayState::ready));
  EXPECT_TRUE(match.world.gameFor(0).kickOff);
  EXPECT_FALSE(match.world.gameFor(1).kickOff);
  ASSERT_TRUE(match.until(PlayState::playing));
  EXPECT_NEAR(match.world.gameFor(0).secondsLeft, 600.0, 0.1);
  EXPECT_EQ(match.world.control().state, PlayState::playing);
}

TEST(RuledWorld, ARobotThatLeavesIsCarriedOffAndBack) {
  Played match(true);
  ASSERT_TRUE(match.until(PlayState::playing));
  match.world.carry(1, {{400.0, 200.0}, Angle()});
  match.goOn(1.2);
  EXPECT_TRUE(match.world.gameFor(1).penalised);
  const Pose2 waits{{-50.0, 270.0 + 1.5 * 45.0}, Angle()};
  EXPECT_LT(distance(match.pose(1).position, waits.position), 2.0);
  const Pose2 shown = match.world.truth(match.world.time()).robots[1].pose;
  EXPECT_LT(distance(shown.position, waits.position), 2.0) << "no image shows the way";
  match.goOn(30.0);
  EXPECT_FALSE(match.world.gameFor(1).penalised);
  EXPECT_LT(distance(match.pose(1).position, {345.0, 270.0}), 2.0);
}

TEST(RuledWorld, AGoalIsReportedToBothTeamsAndTheBallLiesInTheMiddle) {
  Played match(true);
  ASSERT_TRUE(match.until(PlayState::playing));
  match.world.putBall({{180.0, 545.0}, {}});
  match.world.tick();
  EXPECT_EQ(match.world.gameFor(0).ownScore, 1);
  EXPECT_EQ(match.world.gameFor(1).opponentScore, 1);
  EXPECT_TRUE(match.world.gameFor(1).kickOff);
  EXPECT_EQ(match.world.ball().position.y, 270.0);
  EXPECT_EQ(match.world.control().teams[1].score, 1U);
}

}  // namespace
}  // namespace kelpie::sim
