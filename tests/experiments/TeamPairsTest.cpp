// SPDX-License-Identifier: Apache-2.0
// Pairs of matches of two teams that differ in one thing, and what is counted of them.
#include <gtest/gtest.h>

#include "tools/experiments/team/TeamPairs.h"

namespace kelpie::experiments {
namespace {

sim::MatchEvent event(sim::EventKind kind, TeamColour team, const char* reason = "") {
  sim::MatchEvent made;
  made.kind = kind;
  made.team = team;
  made.reason.assign(reason);
  return made;
}

TEST(TeamPairs, AnOwnGoalIsAGoalOfTheOthers) {
  Played played;
  played.events = {event(sim::EventKind::goal, TeamColour::red),
                   event(sim::EventKind::goal, TeamColour::red, "own goal"),
                   event(sim::EventKind::goal, TeamColour::blue)};
  EXPECT_EQ(tallyOf(played, TeamColour::red).goals, 2);
  EXPECT_EQ(tallyOf(played, TeamColour::red).ownGoals, 0);
  EXPECT_EQ(tallyOf(played, TeamColour::blue).goals, 1);
  EXPECT_EQ(tallyOf(played, TeamColour::blue).ownGoals, 1);
}

TEST(TeamPairs, ABallOutIsTheirsWhoTouchedItLast) {
  Played played;
  played.events = {event(sim::EventKind::out, TeamColour::blue),
                   event(sim::EventKind::penalty, TeamColour::blue)};
  EXPECT_EQ(tallyOf(played, TeamColour::blue).outs, 1);
  EXPECT_EQ(tallyOf(played, TeamColour::red).outs, 0);
}

TEST(TeamPairs, SidesAreExchangedInTheSecondMatch) {
  EXPECT_EQ(colourOf(0, 0), TeamColour::red);
  EXPECT_EQ(colourOf(1, 0), TeamColour::blue);
  EXPECT_EQ(colourOf(0, 1), TeamColour::blue);
  EXPECT_EQ(colourOf(1, 1), TeamColour::red);
}

TEST(TeamPairs, AParameterIsGivenToAllRobotsOfItsTeamAndToNoOther) {
  cli::SessionOptions session;
  session.team = "red";
  for (const char* team : {"red", "blue"}) {
    cli::OtherRobot robot;
    robot.team = team;
    session.others.push_back(robot);
  }
  giveParam("a=1", TeamColour::red, session);
  giveParam("b=2", TeamColour::blue, session);
  EXPECT_EQ(session.set, std::vector<std::string>{"a=1"});
  EXPECT_EQ(session.others[0].set, std::vector<std::string>{"a=1"});
  EXPECT_EQ(session.others[1].set, std::vector<std::string>{"b=2"});
}

TEST(TeamPairs, FiguresAreOfAMatchAndTheDifferenceIsTheFirstTeams) {
  PairsTally tally;
  tally.sides[0] = {3, 0, 10};
  tally.sides[1] = {1, 2, 4};
  tally.differences = {1.0, 0.0};
  const Json figures = figuresOf({Side{"one", ""}, Side{"other", ""}}, tally);
  EXPECT_EQ(figures["matches"], 4);
  EXPECT_EQ(figures["difference_per_match"], 0.5);
  EXPECT_EQ(figures["difference_low"], 0.0) << "of pairs drawn again, a quarter are both 0";
  EXPECT_EQ(figures["difference_high"], 1.0);
  EXPECT_EQ(figures["one"]["goals_per_match"], 0.75);
  EXPECT_EQ(figures["one"]["goals_against_per_match"], 0.25);
  EXPECT_EQ(figures["other"]["own_goals_per_match"], 0.5);
  EXPECT_EQ(figures["one"]["outs_per_match"], 2.5);
}

}  // namespace
}  // namespace kelpie::experiments
