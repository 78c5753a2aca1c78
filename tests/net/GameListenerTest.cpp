// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "robot/net/GameListener.h"

namespace kelpie::net {
namespace {

// Blue 3 of the team with number 7.
struct Listener {
  ListenerParams params;
  ListenerState state = listenerFor(TeamColour::blue, 3);
  TimeUs now;

  Listener() { params.teamNumber = 7; }

  static GameControlData match(PlayState play) {
    GameControlData control;
    control.state = play;
    control.kickOff = TeamColour::blue;
    control.teams[0] = {7, TeamColour::blue, 1, {}};
    control.teams[1] = {9, TeamColour::red, 2, {}};
    return control;
  }
  void tell(const GameControlData& control) { hear(packetOf(control), now, params, state); }
  void feelFor(double seconds, double head, bool back) {
    for (double gone = 0.0; gone < seconds - 1e-9; gone += kTickSeconds) {
      now = now + TimeUs{kTickUs};
      ButtonIn in{now, {}};
      in.sensors.headTouch = head;
      in.sensors.back[1] = back;
      feel(in, params, state);
    }
  }
  void rest(double seconds) { feelFor(seconds, 0.0, false); }
  void pressHead(double seconds = 0.3) {
    feelFor(seconds, 20.0, false);
    rest(0.1);
  }
  void pressBack(double seconds) {
    feelFor(seconds, 0.0, true);
    rest(0.1);
  }
  std::uint32_t refused(ControlRefusal reason) const {
    return state.counts.refused[static_cast<std::size_t>(reason)];
  }
};

TEST(GameListener, ARobotThatHasHeardNothingIsInTheInitialState) {
  const Listener robot;
  EXPECT_EQ(robot.state.game.state, PlayState::initial);
  EXPECT_EQ(robot.state.game.team, TeamColour::blue);
  EXPECT_EQ(robot.state.game.player, 3);
}

TEST(GameListener, APacketIsTheMatchAsThisRobotKnowsIt) {
  Listener robot;
  GameControlData control = Listener::match(PlayState::set);
  control.teams[0].players[2] = {ControlPenalty::damage, 20};
  robot.tell(control);
  const GameState& game = robot.state.game;
  EXPECT_EQ(game.state, PlayState::set);
  EXPECT_TRUE(game.penalised && game.kickOff);
  EXPECT_EQ(game.ownScore, 1);
  EXPECT_EQ(game.opponentScore, 2);
  EXPECT_EQ(game.player, 3);
  EXPECT_EQ(robot.state.counts.taken, 1U);
}

TEST(GameListener, WhatIsNoPacketOfThisMatchChangesNothingAndIsCounted) {
  Listener robot;
  const auto spoil = [&](std::size_t place, std::uint8_t byte) {
    ControlPacket packet = packetOf(Listener::match(PlayState::playing));
    packet.bytes[place] = byte;
    hear(packet, robot.now, robot.params, robot.state);
  };
  spoil(0, 'X');
  spoil(4, 7);
  ControlPacket shorter = packetOf(Listener::match(PlayState::playing));
  shorter.bytes.resize(119);
  hear(shorter, robot.now, robot.params, robot.state);
  GameControlData others = Listener::match(PlayState::playing);
  others.teams[0].number = 8;
  robot.tell(others);
  EXPECT_EQ(robot.refused(ControlRefusal::header), 1U);
  EXPECT_EQ(robot.refused(ControlRefusal::version), 1U);
  EXPECT_EQ(robot.refused(ControlRefusal::size), 1U);
  EXPECT_EQ(robot.refused(ControlRefusal::foreign), 1U);
  EXPECT_EQ(robot.state.counts.taken, 0U);
  EXPECT_EQ(robot.state.game.state, PlayState::initial);
}

TEST(GameListener, ThePacketThatGivesTheTeamTheOtherColourIsForeign) {
  Listener robot;
  GameControlData control = Listener::match(PlayState::playing);
  std::swap(control.teams[0].number, control.teams[1].number);
  robot.tell(control);
  EXPECT_EQ(robot.refused(ControlRefusal::foreign), 1U);
}

TEST(GameListener, WithoutATeamNumberEveryMatchIsTheRobots) {
  Listener robot;
  robot.params.teamNumber = -1;
  GameControlData control = Listener::match(PlayState::playing);
  control.teams[0].number = 8;
  robot.tell(control);
  EXPECT_EQ(robot.state.game.state, PlayState::playing);
}

TEST(GameListener, WhileTheControllerIsHeardButtonsHaveNoEffect) {
  Listener robot;
  robot.tell(Listener::match(PlayState::set));
  robot.pressHead();
  robot.pressBack(1.2);
  EXPECT_EQ(robot.state.game.state, PlayState::set);
  EXPECT_FALSE(robot.state.game.penalised);
}

TEST(GameListener, WhenTheControllerFallsSilentTheLastStateHolds) {
  Listener robot;
  robot.tell(Listener::match(PlayState::playing));
  robot.rest(60.0);
  EXPECT_EQ(robot.state.game.state, PlayState::playing);
  EXPECT_EQ(robot.state.game.ownScore, 1);
}

TEST(GameListener, ThenButtonsGoOnFromTheLastState) {
  Listener robot;
  robot.tell(Listener::match(PlayState::set));
  robot.rest(3.5);
  robot.pressHead();
  EXPECT_EQ(robot.state.game.state, PlayState::playing);
  EXPECT_FALSE(robot.state.game.kickOff);
  EXPECT_EQ(robot.state.game.opponentScore, 2) << "what no button tells stays";
  robot.pressBack(1.2);
  EXPECT_TRUE(robot.state.game.penalised);
  robot.pressHead();
  EXPECT_FALSE(robot.state.game.penalised);
}

TEST(GameListener, AHoldThatBeganWhileTheControllerWasHeardDoesNotPressWhenItEndsUnheard) {
  Listener robot;
  robot.tell(Listener::match(PlayState::ready));
  robot.feelFor(3.5, 20.0, false);
  EXPECT_EQ(robot.state.game.state, PlayState::initial) << "held for 3 s, and nobody is heard";
  robot.rest(0.1);
  EXPECT_EQ(robot.state.game.state, PlayState::initial);
}

TEST(GameListener, TheNextPacketRulesAgain) {
  Listener robot;
  robot.pressHead();
  EXPECT_EQ(robot.state.game.state, PlayState::ready) << "no controller was ever heard";
  robot.tell(Listener::match(PlayState::finished));
  EXPECT_EQ(robot.state.game.state, PlayState::finished);
  robot.rest(0.5);
  EXPECT_EQ(robot.state.game.state, PlayState::finished);
}

TEST(GameListener, TheHandThatCarriesARobotByItsBackChangesNothing) {
  Listener robot;
  robot.pressBack(0.2);
  EXPECT_EQ(robot.state.game.state, PlayState::initial);
  robot.tell(Listener::match(PlayState::playing));
  robot.rest(3.5);
  robot.pressBack(1.2);
  robot.pressBack(0.2);
  EXPECT_TRUE(robot.state.game.penalised) << "the rule book's head button takes it back";
}

}  // namespace
}  // namespace kelpie::net
