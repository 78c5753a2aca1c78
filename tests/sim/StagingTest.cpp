// SPDX-License-Identifier: Apache-2.0
// Who starts where: scenarios, places of one's own, and balls that are thrown later.
#include <gtest/gtest.h>

#include <cmath>

#include "tools/sim/staging/Staging.h"
#include "tools/sim/world/World.h"

namespace kelpie::sim {
namespace {

constexpr host::AgentHello kRed1{TeamColour::red, 1};
constexpr host::AgentHello kBlue1{TeamColour::blue, 1};

const body::FieldDescription& field() {
  static const body::FieldDescription field = *body::fieldDescription("2006");
  return field;
}

Expected<Setup> staged(const std::vector<host::AgentHello>& agents, const StagingWords& words,
                       const std::string& name = "attack", std::uint64_t seed = 1) {
  const auto staging = stagingFrom(words);
  if (!staging) return Error{staging.error()};
  return stagedScenario(name, field(), agents, seed, *staging);
}

bool inABox(Point2<Field> p) {
  return std::fabs(p.x - 180.0) < 65.0 && (p.y < 65.0 || p.y > 475.0);
}

TEST(Scenario, AttackHasTheAttackerFarFromTheGoalAndTheKeeperInIt) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    const auto setup = scenario("attack", field(), {kRed1, kBlue1}, seed);
    ASSERT_TRUE(setup);
    EXPECT_LE(setup->players[0].start.position.y, 324.0);
    EXPECT_GE(distance(setup->ball, setup->players[0].start.position), 40.0);
    EXPECT_FALSE(inABox(setup->ball));
    EXPECT_EQ(setup->players[1].start.position.x, 180.0);
    EXPECT_EQ(setup->players[1].start.position.y, 520.0);
    EXPECT_EQ(setup->players[1].start.heading.deg(), -90.0);
  }
}

TEST(Scenario, AttackDrawsTheSameWithAndWithoutKeeper) {
  const auto alone = scenario("attack", field(), {kRed1}, 7);
  const auto both = scenario("attack", field(), {kRed1, kBlue1}, 7);
  ASSERT_TRUE(alone && both);
  EXPECT_EQ(alone->ball.x, both->ball.x);
  EXPECT_EQ(alone->players[0].start.position.y, both->players[0].start.position.y);
}

TEST(Scenario, AttackOfABlueRobotIsTurnedRound) {
  const auto red = scenario("attack", field(), {kRed1}, 7);
  const auto blue = scenario("attack", field(), {kBlue1}, 7);
  ASSERT_TRUE(red && blue);
  EXPECT_NEAR(blue->ball.y, 540.0 - red->ball.y, 1e-9);
  EXPECT_GE(blue->players[0].start.position.y, 216.0);
}

TEST(Scenario, AttackIsForOneRobotOfEachTeamAtMost) {
  EXPECT_FALSE(scenario("attack", field(), {kRed1, {TeamColour::red, 2}}, 1));
  EXPECT_FALSE(scenario("empty-goal", field(), {kRed1, kBlue1}, 1));
}

TEST(Staging, WordsMeanTheSameAgain) {
  for (const char* words : {"red:1:180,100.5,90", "blue:4:20,30,-45"}) {
    const auto place = placeFrom(words);
    ASSERT_TRUE(place) << place.error();
    EXPECT_EQ(wordsFor(*place), words);
  }
  for (const char* words : {"4.5:180,270,-80,0.25", "0:-20,10,0,5:red:1"}) {
    const auto thrown = throwFrom(words);
    ASSERT_TRUE(thrown) << thrown.error();
    EXPECT_EQ(wordsFor(*thrown), words);
  }
  EXPECT_EQ(wordsFor(*ballFrom("1,2")), "1,2,0,0");
  for (const char* words : {"30:5", "30:2.5:100,200"}) EXPECT_EQ(wordsFor(*takeFrom(words)), words);
  EXPECT_EQ(wordsFor(*takeFrom("30")), "30:5");
  EXPECT_EQ(wordsFor(*carryFrom("30:blue:2:100,200,90")), "30:blue:2:100,200,90");
}

TEST(Staging, WhatIsNoTakingOrCarryingIsRefusedWithItsWords) {
  for (const char* words : {"", "x", "-1", "1:2:3", "1:x", "1:-2", "1:2:3,4:5", "1,2", "1:2:3,4,5"})
    EXPECT_NE(takeFrom(words).error().find(words), std::string::npos) << words;
  for (const char* words : {"", "30", "red:1:1,2,3", "30:red:1:1,2", "30:red:5:1,2,3",
                            "-1:red:1:1,2,3", "30:red:1:1,2,nan"})
    EXPECT_NE(carryFrom(words).error().find(words), std::string::npos) << words;
}

TEST(Staging, WhatIsNoPlaceBallOrThrowIsRefusedWithItsWords) {
  for (const char* words : {"", "red:1", "red:1:180,100", "green:1:1,2,3", "red:5:1,2,3",
                            "red:1:1,2,x", "red:1:1,2,nan", "red:1:1,2,3:4", "red:12:1,2,3"})
    EXPECT_NE(placeFrom(words).error().find(words), std::string::npos) << words;
  for (const char* words : {"", "1", "1,2,3", "1,,2,3", "1,2,inf,0", "1,2,3,4,5", "0,0,300,1"})
    EXPECT_FALSE(ballFrom(words)) << words;
  for (const char* words :
       {"1,2,3,4", "1:1,2", "-1:1,2,3,4", "1:1,2,3,4:red", "1:1,2,3,4:red:0", "1:1,2,3,4:robot"})
    EXPECT_FALSE(throwFrom(words)) << words;
}

TEST(Staging, PlacesStandInForTheScenarios) {
  const auto setup = staged({kRed1, kBlue1}, {{"blue:1:180,300,-90"}, "100,200", {}});
  ASSERT_TRUE(setup) << setup.error();
  EXPECT_TRUE(setup->players[0].is(kRed1));
  EXPECT_EQ(setup->players[1].start.position.y, 300.0);
  EXPECT_EQ(setup->ball.x, 100.0);
  const auto alone = scenario("attack", field(), {kRed1}, 1);
  EXPECT_EQ(setup->players[0].start.position.x, alone->players[0].start.position.x);
}

TEST(Staging, WhatCannotBeIsRefusedInOneLine) {
  const auto refused = [](const StagingWords& words) {
    const auto setup = staged({kRed1, kBlue1}, words);
    return setup ? std::string() : setup.error();
  };
  EXPECT_EQ(refused({{"red:2:100,100,0"}, "", {}}), "no red 2 is there to be placed");
  EXPECT_EQ(refused({{"red:1:100,100,0", "red:1:200,100,0"}, "", {}}), "red 1 is placed twice");
  EXPECT_EQ(refused({{"red:1:-1,100,0"}, "", {}}), "red 1 at (-1, 100) is off the field");
  EXPECT_EQ(refused({{}, "10,541", {}}), "the ball at (10, 541) is off the field");
  EXPECT_EQ(refused({{}, "", {"1:361,10,0,0"}}), "the ball at (361, 10) is off the field");
  EXPECT_EQ(refused({{}, "", {"1:0,10,0,0:blue:3"}}), "no blue 3 is there to throw a ball from");
  EXPECT_EQ(refused({{"red:1:180,100,90"}, "180,112", {}}), "red 1 would stand on the ball");
  EXPECT_EQ(refused({{"red:1:180,100,90", "blue:1:190,115,-90"}, "10,10", {}}),
            "blue 1 would stand in red 1");
  EXPECT_EQ(refused({{"blue:1:138,535,-90"}, "", {}}), "blue 1 would stand in a goal or beacon");
  EXPECT_EQ(refused({{}, "", {"1:0,10,0,0:red:1"}}), "");
}

TEST(Staging, HandsThatCannotBeAreRefusedInOneLine) {
  const auto refused = [](const std::vector<std::string>& takes,
                          const std::vector<std::string>& carries,
                          const std::vector<std::string>& throws = {}) {
    const auto setup = staged({kRed1, kBlue1}, {{}, "", throws, takes, carries});
    return setup ? std::string() : setup.error();
  };
  EXPECT_EQ(refused({"1:2:-5,10"}, {}), "the ball at (-5, 10) is off the field");
  EXPECT_EQ(refused({"5", "1:6"}, {}), "the ball is taken at 5 s, but away until 7 s");
  EXPECT_EQ(refused({"5"}, {}, {"6:100,100,0,0"}),
            "the ball is thrown at 6 s, but away from 5 to 10 s");
  EXPECT_EQ(refused({}, {"1:red:2:100,100,0"}), "no red 2 is there to be carried");
  EXPECT_EQ(refused({}, {"1:red:1:100,600,0"}), "red 1 at (100, 600) is off the field");
  EXPECT_EQ(refused({}, {"1:blue:1:138,535,-90"}), "blue 1 would stand in a goal or beacon");
  EXPECT_EQ(refused({"6", "1"}, {"1:red:1:100,100,0"}), "");
}

// Where the ball is at those times, in a world of kinematic bodies.
std::vector<Ball> ballsAt(const Setup& setup, const std::vector<double>& seconds) {
  World world({}, field(), setup, 3);
  std::vector<Ball> balls;
  for (const double until : seconds) {
    while (world.time().seconds() < until) world.tick();
    balls.push_back(world.ball());
  }
  return balls;
}

TEST(Staging, ABallMayRollFromTheStart) {
  const auto setup = staged({kRed1}, {{"red:1:60,60,90"}, "180,270,50,0", {}});
  ASSERT_TRUE(setup);
  EXPECT_GT(ballsAt(*setup, {1.0})[0].position.x, 200.0);
}

TEST(Staging, AThrownBallIsThereAtItsTimeAndNotBefore) {
  const auto setup =
      staged({kRed1}, {{"red:1:60,60,90"}, "180,270", {"0.8:100,400,0,-60", "0.4:250,300,0,0"}});
  ASSERT_TRUE(setup);
  const auto balls = ballsAt(*setup, {0.392, 0.4, 0.8});
  EXPECT_EQ(balls[0].position.x, 180.0);
  EXPECT_EQ(balls[1].position.x, 250.0);
  EXPECT_EQ(balls[2].position.x, 100.0);
  EXPECT_EQ(balls[2].velocity.y, -60.0);
}

TEST(Staging, AThrowOfARobotGoesByWhereItStandsThen) {
  const auto setup = staged({kRed1}, {{"red:1:200,100,180"}, "180,270", {"0.4:20,50,0,60:red:1"}});
  ASSERT_TRUE(setup);
  // It looks along -x: its right is +y.
  const Ball ball = ballsAt(*setup, {0.4})[0];
  EXPECT_NEAR(ball.position.x, 150.0, 0.5);
  EXPECT_NEAR(ball.position.y, 120.0, 0.5);
  EXPECT_NEAR(ball.velocity.x, -60.0, 0.5);
}

TEST(Staging, ABallThatIsTakenIsAwayForItsTimeAndNoBallIsOutMeanwhile) {
  const auto setup = staged({kRed1}, {{"red:1:60,60,90"}, "180,270", {}, {"0.4:0.4:100,200"}});
  ASSERT_TRUE(setup);
  World world({}, field(), *setup, 3);
  std::vector<MatchEvent> events;
  while (world.time().seconds() < 1.2) {
    world.tick();
    for (const MatchEvent& event : world.takeEvents()) events.push_back(event);
    const double now = world.time().seconds();
    const bool away = now >= 0.4 && now < 0.8;
    EXPECT_EQ(world.ball().position.x, away ? kAwayBall.x : now < 0.4 ? 180.0 : 100.0) << now;
  }
  ASSERT_EQ(events.size(), 3U);
  EXPECT_EQ(events[0].kind, EventKind::start);
  EXPECT_EQ(events[1].kind, EventKind::taken);
  EXPECT_EQ(events[1].ball.x, 180.0);
  EXPECT_EQ(events[2].kind, EventKind::returned);
  EXPECT_EQ(events[2].place.y, 200.0);
  EXPECT_EQ(world.score().outs, 0);
}

TEST(Staging, ARobotIsCarriedWhenItsPlaceIsFree) {
  const auto setup = staged(
      {kRed1}, {{"red:1:60,60,90"}, "180,270", {"0.8:300,400,0,0"}, {}, {"0.4:red:1:180,270,0"}});
  ASSERT_TRUE(setup);
  World world({}, field(), *setup, 3);
  std::vector<MatchEvent> events;
  while (world.time().seconds() < 1.2) {
    world.tick();
    for (const MatchEvent& event : world.takeEvents()) events.push_back(event);
    const double x = world.truth(world.time()).robots[0].pose.position.x;
    EXPECT_NEAR(x, world.time().seconds() < 0.8 ? 60.0 : 180.0, 3.0);  // the ball lay there
  }
  ASSERT_EQ(events.size(), 2U);
  EXPECT_EQ(events[1].kind, EventKind::carried);
  EXPECT_EQ(events[1].player, 1);
}

TEST(Staging, AThrowBeyondTheLinesStaysOnTheField) {
  const auto setup = staged({kRed1}, {{"red:1:200,30,-90"}, "180,270", {"0.4:0,100,0,0:red:1"}});
  ASSERT_TRUE(setup);
  EXPECT_EQ(ballsAt(*setup, {0.4})[0].position.y, 0.0);
}

}  // namespace
}  // namespace kelpie::sim
