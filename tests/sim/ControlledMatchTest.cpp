// SPDX-License-Identifier: Apache-2.0
// A match that a game controller outside rules: what it says is done, and what it does not say is
// left alone.
#include <gtest/gtest.h>

#include <algorithm>

#include "tools/sim/world/World.h"

namespace kelpie::sim {
namespace {

constexpr TeamColour kRed = TeamColour::red;
constexpr TeamColour kBlue = TeamColour::blue;
const std::vector<host::AgentHello> kTwo{{kRed, 2}, {kBlue, 2}};

struct Played {
  Played() : world(params(), field, *scenario("kickoff", field, kTwo, 3), 3) {
    control.teams[0] = {12, kBlue, 0, {}};
    control.teams[1] = {34, kRed, 0, {}};
  }

  static WorldParams params() {
    WorldParams params;
    params.referee.rules = true;
    params.referee.controlled = true;
    params.referee.seconds = 1000.0;
    params.spectators = false;
    return params;
  }
  void goOn(double seconds) {
    for (int i = 0; i * kTickSeconds < seconds; ++i) world.tick();
    for (const MatchEvent& event : world.takeEvents()) events.push_back(event);
  }
  // And one tick of the world.
  void tell() {
    world.hear(control);
    goOn(0.001);
  }
  void tell(PlayState state) {
    control.state = state;
    tell();
  }
  std::size_t count(EventKind kind) const {
    const auto is = [kind](const MatchEvent& event) { return event.kind == kind; };
    return static_cast<std::size_t>(std::count_if(events.begin(), events.end(), is));
  }
  Point2<Field> place(std::size_t robot) { return world.bodies().place(robot).pose.position; }
  Point2<Field> middle() const { return {0.5 * field.width, 0.5 * field.length}; }

  body::FieldDescription field = *body::fieldDescription("2006");
  World world;
  net::GameControlData control;
  std::vector<MatchEvent> events;
};

TEST(ControlledMatch, NothingBeginsUntilTheControllerIsHeard) {
  Played match;
  match.goOn(60.0);
  EXPECT_EQ(match.world.gameFor(0).state, PlayState::initial);
  EXPECT_EQ(match.events.size(), 1U);
  EXPECT_FALSE(match.world.finished());
}

TEST(ControlledMatch, EachStateIsTheControllersAndLastsUntilItSaysOtherwise) {
  Played match;
  for (const PlayState state : {PlayState::ready, PlayState::set, PlayState::playing}) {
    match.tell(state);
    match.goOn(50.0);
    EXPECT_EQ(match.world.gameFor(0).state, state);
  }
  EXPECT_EQ(match.count(EventKind::ready), 1U);
  EXPECT_EQ(match.count(EventKind::set), 1U);
  EXPECT_EQ(match.count(EventKind::play), 1U);
  EXPECT_EQ(match.world.control().teams[1].number, 34U) << "robots are told all that it says";
}

TEST(ControlledMatch, APenalisedRobotIsPutOffTheFieldUntilTheControllerTakesItBack) {
  Played match;
  match.tell(PlayState::playing);
  match.control.teams[1].players[1] = {net::ControlPenalty::playerPushing, 30};
  match.tell();
  EXPECT_TRUE(match.world.gameFor(0).penalised);
  EXPECT_FALSE(match.world.gameFor(1).penalised);
  EXPECT_LT(match.place(0).x, 0.0);
  match.goOn(60.0);
  EXPECT_TRUE(match.world.gameFor(0).penalised) << "its time is the controller's too";
  ASSERT_TRUE(match.world.carry(0, {{100.0, 100.0}, Angle()}));
  match.goOn(0.1);
  EXPECT_LT(match.place(0).x, 0.0) << "who strays is brought back";
  match.control.teams[1].players[1] = {};
  match.tell();
  EXPECT_FALSE(match.world.gameFor(0).penalised);
  EXPECT_NEAR(match.place(0).y, 0.5 * match.field.length, 1.0);
  EXPECT_GT(match.place(0).x, 0.0);
  ASSERT_EQ(match.count(EventKind::penalty), 1U);
  EXPECT_EQ(match.count(EventKind::back), 1U);
}

TEST(ControlledMatch, TheWorldPenalisesNobody) {
  Played match;
  match.tell(PlayState::playing);
  match.world.carry(1, {{400.0, 200.0}, Angle()});
  match.goOn(5.0);
  EXPECT_FALSE(match.world.gameFor(1).penalised);
}

TEST(ControlledMatch, ABallInAGoalCountsOnlyWhenTheControllerSaysSo) {
  Played match;
  match.tell(PlayState::playing);
  match.world.putBall({{180.0, 545.0}, {0.0, 5.0}});
  match.goOn(5.0);
  EXPECT_EQ(match.world.score().red, 0);
  EXPECT_NEAR(match.world.ball().position.y, 545.0, 0.1) << "it lies there until somebody decides";
  match.control.teams[1].score = 1;
  match.control.kickOff = kBlue;
  match.tell(PlayState::ready);
  EXPECT_EQ(match.world.score().red, 1);
  EXPECT_EQ(match.world.gameFor(0).ownScore, 1);
  EXPECT_TRUE(match.world.gameFor(1).kickOff);
  EXPECT_EQ(match.world.ball().position.y, match.middle().y);
  EXPECT_EQ(match.count(EventKind::goal), 1U);
}

TEST(ControlledMatch, AGoalThatIsTakenBackIsNone) {
  Played match;
  match.control.teams[0].score = 2;
  match.tell(PlayState::playing);
  match.control.teams[0].score = 1;
  match.tell();
  EXPECT_EQ(match.world.score().blue, 1);
  EXPECT_EQ(match.world.score().goals.size(), 1U);
}

TEST(ControlledMatch, ABallThatGoesOutIsPutBackAtOnce) {
  Played match;
  match.tell(PlayState::playing);
  match.world.putBall({{-10.0, 300.0}, {}});
  match.goOn(0.1);
  EXPECT_EQ(match.world.ball().position.x, match.field.rules.throwInFromSide);
  EXPECT_EQ(match.world.score().outs, 1);
  match.control.dropInTeam = kRed;
  match.control.dropInSeconds = 0;
  const Point2<Field> before = match.world.ball().position;
  match.tell();
  EXPECT_EQ(match.world.ball().position.x, before.x) << "the controller tells of the same out";
  EXPECT_EQ(match.count(EventKind::stuck), 0U);
}

TEST(ControlledMatch, ADropInThatIsReportedOfABallInPlayIsDone) {
  Played match;
  match.tell(PlayState::playing);
  match.control.dropInSeconds = 0;
  match.tell();
  EXPECT_EQ(match.count(EventKind::stuck), 1U);
  EXPECT_GT(distance(match.world.ball().position, match.middle()), 50.0);
}

TEST(ControlledMatch, AtSetTheBallLiesInTheMiddleAndNobodyStandsWhereItMayNot) {
  Played match;
  match.tell(PlayState::ready);
  match.world.putBall({{50.0, 50.0}, {}});
  match.world.carry(0, {{180.0, 400.0}, Angle::deg(90.0)});
  match.tell(PlayState::set);
  EXPECT_LT(distance(match.world.ball().position, match.middle()), 1.0);
  EXPECT_LT(match.place(0).y, 0.5 * match.field.length);
  EXPECT_EQ(match.count(EventKind::placed), 1U);
  match.world.putBall({{50.0, 50.0}, {}});
  match.goOn(0.1);
  EXPECT_LT(distance(match.world.ball().position, match.middle()), 1.0) << "and stays there";
}

TEST(ControlledMatch, ItEndsWhenTheSecondHalfIsFinished) {
  Played match;
  match.tell(PlayState::playing);
  match.control.firstHalf = false;
  match.tell(PlayState::finished);
  EXPECT_TRUE(match.world.finished());
  EXPECT_EQ(match.count(EventKind::end), 1U);
}

TEST(ControlledMatch, AfterTheFirstHalfItEndsOnlyWhenTheControllerFallsSilent) {
  Played match;
  match.tell(PlayState::playing);
  for (int i = 0; i < 60; ++i) {
    match.tell(PlayState::finished);
    match.goOn(0.5);
  }
  EXPECT_FALSE(match.world.finished()) << "it is the break";
  match.goOn(6.0);
  EXPECT_TRUE(match.world.finished());
  EXPECT_EQ(match.count(EventKind::half), 1U);
}

TEST(ControlledMatch, AControllerThatFallsSilentInPlayLeavesTheMatchAsItIs) {
  Played match;
  match.tell(PlayState::playing);
  match.goOn(60.0);
  EXPECT_EQ(match.world.gameFor(0).state, PlayState::playing);
  EXPECT_FALSE(match.world.finished());
}

}  // namespace
}  // namespace kelpie::sim
