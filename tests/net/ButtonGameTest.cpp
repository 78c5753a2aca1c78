// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "robot/net/ButtonGame.h"

namespace kelpie::net {
namespace {

enum class Where { head, back };

struct Hand {
  ButtonParams params;
  ButtonState state;
  ButtonGame game;
  TimeUs now;

  void hold(double seconds, double head, bool back) {
    ButtonIn in;
    in.sensors.headTouch = head;
    in.sensors.back[1] = back;
    for (double gone = 0.0; gone < seconds - 1e-9; gone += kTickSeconds) {
      now = now + TimeUs{kTickUs};
      in.time = now;
      game = step(in, params, state);
    }
  }
  // Then lets go.
  void press(Where where, double seconds) {
    hold(seconds, where == Where::head ? 20.0 : 0.0, where == Where::back);
    hold(0.2, 0.0, false);
  }
  bool is(PlayState play, bool penalised = false) const {
    return game.state == play && game.penalised == penalised;
  }
};

TEST(ButtonGame, PressesGoThroughTheStatesUpToPlaying) {
  for (const Where where : {Where::head, Where::back}) {
    Hand hand;
    for (const PlayState next :
         {PlayState::ready, PlayState::set, PlayState::playing, PlayState::playing}) {
      hand.press(where, 0.3);
      EXPECT_TRUE(hand.is(next));
    }
  }
}

TEST(ButtonGame, ATouchOfLessThanATenthOfASecondIsNone) {
  Hand hand;
  hand.press(Where::head, 0.08);
  hand.press(Where::back, 0.08);
  EXPECT_TRUE(hand.is(PlayState::initial));
  hand.press(Where::back, 0.12);
  EXPECT_TRUE(hand.is(PlayState::ready));
}

TEST(ButtonGame, ALightTouchOfTheHeadIsNone) {
  Hand hand;
  hand.hold(0.5, 9.9, false);
  hand.hold(0.5, 0.0, false);
  EXPECT_TRUE(hand.is(PlayState::initial));
  hand.hold(0.5, 10.0, false);
  hand.hold(0.5, 0.0, false);
  EXPECT_TRUE(hand.is(PlayState::ready));
}

TEST(ButtonGame, TheBackForASecondPenalisesAndAPressTakesItBack) {
  Hand hand;
  for (int i = 0; i < 3; ++i) hand.press(Where::head, 0.3);
  hand.hold(0.99, 0.0, true);
  EXPECT_TRUE(hand.is(PlayState::playing));
  hand.hold(0.1, 0.0, true);
  EXPECT_TRUE(hand.is(PlayState::playing, true));
  hand.hold(5.0, 0.0, true);
  hand.hold(0.2, 0.0, false);
  EXPECT_TRUE(hand.is(PlayState::playing, true)) << "the end of that press is no other one";
  hand.press(Where::head, 0.3);
  EXPECT_TRUE(hand.is(PlayState::playing));
}

TEST(ButtonGame, NobodyIsPenalisedBeforeTheMatch) {
  Hand hand;
  hand.press(Where::back, 1.5);
  EXPECT_TRUE(hand.is(PlayState::initial));
}

TEST(ButtonGame, TheHeadForThreeSecondsStartsAnew) {
  Hand hand;
  for (int i = 0; i < 3; ++i) hand.press(Where::head, 0.3);
  hand.press(Where::back, 1.5);
  hand.hold(2.98, 20.0, false);
  EXPECT_TRUE(hand.is(PlayState::playing, true));
  hand.hold(0.1, 20.0, false);
  EXPECT_TRUE(hand.is(PlayState::initial));
  hand.hold(0.2, 0.0, false);
  EXPECT_TRUE(hand.is(PlayState::initial)) << "the end of that press is no other one";
}

TEST(ButtonGame, AHandAtTheBackCanBeLeftWithoutEffect) {
  Hand hand;
  hand.params.backAdvances = false;
  hand.press(Where::back, 0.3);
  EXPECT_TRUE(hand.is(PlayState::initial));
  hand.press(Where::head, 0.3);
  EXPECT_TRUE(hand.is(PlayState::ready));
}

}  // namespace
}  // namespace kelpie::net
