// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "robot/core/fields/FieldCheck.h"
#include "tools/session/RefereeWords.h"

namespace kelpie::cli {
namespace {

struct Desk {
  RefereeDesk desk = refereeDesk(5, 6, 600.0);

  void hear(const std::string& line) {
    const Status said = say(line, desk);
    EXPECT_TRUE(said) << line;
  }
  const net::ControlTeam& red() const { return desk.control.teams[1]; }
  const net::ControlTeam& blue() const { return desk.control.teams[0]; }
};

TEST(RefereeWords, EachStateHasItsWord) {
  Desk desk;
  EXPECT_EQ(desk.desk.control.state, PlayState::initial);
  const std::pair<const char*, PlayState> words[] = {{"ready", PlayState::ready},
                                                     {"set", PlayState::set},
                                                     {"playing", PlayState::playing},
                                                     {"finished", PlayState::finished},
                                                     {"initial", PlayState::initial}};
  for (const auto& [word, state] : words) {
    desk.hear(word);
    EXPECT_EQ(desk.desk.control.state, state);
  }
}

TEST(RefereeWords, AGoalIsFollowedByTheOtherTeamsKickOff) {
  Desk desk;
  desk.hear("playing");
  desk.hear("goal red");
  EXPECT_EQ(desk.red().score, 1U);
  EXPECT_EQ(desk.blue().score, 0U);
  EXPECT_EQ(desk.desk.control.state, PlayState::ready);
  EXPECT_EQ(desk.desk.control.kickOff, TeamColour::blue);
}

TEST(RefereeWords, APenaltyCountsDownAndStaysUntilItIsTakenBack) {
  Desk desk;
  desk.hear("penalise blue 3 pushing");
  EXPECT_EQ(desk.blue().players[2].penalty, net::ControlPenalty::playerPushing);
  EXPECT_EQ(desk.blue().players[2].secondsLeft, 30U);
  goOn(10.5, desk.desk);
  EXPECT_EQ(desk.blue().players[2].secondsLeft, 20U);
  goOn(100.0, desk.desk);
  EXPECT_EQ(desk.blue().players[2].secondsLeft, 0U);
  EXPECT_NE(desk.blue().players[2].penalty, net::ControlPenalty::none);
  desk.hear("back blue 3");
  EXPECT_EQ(desk.blue().players[2].penalty, net::ControlPenalty::none);
}

TEST(RefereeWords, TheHalfsClockRunsInPlayOnlyAndBeginsAnewInTheSecond) {
  Desk desk;
  desk.hear("ready");
  goOn(20.0, desk.desk);
  EXPECT_EQ(desk.desk.control.secondsLeft, 600U);
  desk.hear("playing");
  goOn(20.0, desk.desk);
  EXPECT_EQ(desk.desk.control.secondsLeft, 580U);
  desk.hear("penalise red 1");
  desk.hear("half");
  EXPECT_EQ(desk.desk.control.secondsLeft, 600U);
  EXPECT_FALSE(desk.desk.control.firstHalf);
  EXPECT_EQ(desk.desk.control.state, PlayState::initial);
  EXPECT_EQ(desk.desk.control.kickOff, TeamColour::blue);
  EXPECT_EQ(desk.red().players[0].penalty, net::ControlPenalty::none);
}

TEST(RefereeWords, TheSecondHalfBeginsOnce) {
  Desk desk;
  desk.hear("half");
  EXPECT_FALSE(say("half", desk.desk));
  EXPECT_EQ(desk.desk.control.kickOff, TeamColour::blue);
}

TEST(RefereeWords, AnOutIsADropInWhoseTimeRuns) {
  Desk desk;
  EXPECT_EQ(desk.desk.control.dropInSeconds, net::kNoDropIn);
  goOn(5.0, desk.desk);
  desk.hear("out red");
  EXPECT_EQ(desk.desk.control.dropInTeam, TeamColour::red);
  EXPECT_EQ(desk.desk.control.dropInSeconds, 0U);
  goOn(7.0, desk.desk);
  EXPECT_EQ(desk.desk.control.dropInSeconds, 7U);
}

TEST(RefereeWords, WhatCannotBeMeantIsOneLineAndChangesNothing) {
  const char* wrong[] = {"reedy",
                         "goal",
                         "goal green",
                         "penalise red",
                         "penalise red 5",
                         "penalise red x",
                         "penalise red 1 y",
                         "wait",
                         "wait soon",
                         "wait -1",
                         "ready set",
                         "back blue 0",
                         "set red 1",
                         "quit now",
                         "penalise red 1 defence 2"};
  for (const char* line : wrong) {
    Desk desk;
    const net::GameControlData before = desk.desk.control;
    const Status said = say(line, desk.desk);
    ASSERT_FALSE(said) << line;
    EXPECT_EQ(said.error().find('\n'), std::string::npos);
    EXPECT_FALSE(firstDifference(before, desk.desk.control, nullptr)) << line;
    EXPECT_FALSE(desk.desk.quits);
  }
}

TEST(RefereeWords, EmptyLinesAndNotesAreNoMistakes) {
  Desk desk;
  desk.hear("");
  desk.hear("  # the first half");
  EXPECT_EQ(desk.desk.control.state, PlayState::initial);
}

TEST(RefereeWords, WhatIsSentIsAlwaysAPacket) {
  Desk desk;
  for (const char* line : {"kickoff blue", "goal red", "out blue", "penalise red 4 damage"})
    desk.hear(line);
  goOn(1e6, desk.desk);
  const auto bytes = net::encodeControl(desk.desk.control);
  net::GameControlData back;
  EXPECT_FALSE(net::decodeControl(bytes.data(), bytes.size(), back));
  EXPECT_EQ(back.teams[1].number, 5U);
}

}  // namespace
}  // namespace kelpie::cli
