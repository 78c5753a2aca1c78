// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "tools/match/TraceWords.h"

namespace kelpie::match {
namespace {

TraceStep step(const std::string& module, const std::string& branch, const std::string& reason,
               std::initializer_list<double> numbers = {}) {
  TraceStep made;
  made.layer = TraceLayer::skill;
  made.module.assign(module);
  made.branch.assign(branch);
  made.reason.assign(reason);
  for (const double number : numbers) made.numbers.push_back(number);
  return made;
}

TEST(TraceWords, NumbersAreAsPreciseAsAPersonWants) {
  EXPECT_EQ(shortNumber(83.4), "83");
  EXPECT_EQ(shortNumber(-123.6), "-124");
  EXPECT_EQ(shortNumber(8.26), "8.3");
  EXPECT_EQ(shortNumber(8.0), "8");
  EXPECT_EQ(shortNumber(9.96), "10");
  EXPECT_EQ(shortNumber(0.127), "0.13");
  EXPECT_EQ(shortNumber(-0.001), "0");
  EXPECT_EQ(shortNumber(0.0), "0");
  EXPECT_EQ(shortNumber(1e6), "1000000");
}

TEST(TraceWords, NumbersFillTheirPlacesInOrder) {
  EXPECT_EQ(reasonOf(step("m", "b", "the gap is {} deg, {} cm away", {12.6, 80.0})),
            "the gap is 13 deg, 80 cm away");
  EXPECT_EQ(reasonOf(step("m", "b", "{}", {1.0, 2.0})), "1");
}

TEST(TraceWords, APlaceWithoutANumberIsAQuestionMark) {
  EXPECT_EQ(reasonOf(step("m", "b", "{} of {}{", {3.0})), "3 of ?{");
}

TEST(TraceWords, ALineAndASentenceNameWhoChoseWhatAndWhy) {
  const TraceStep aim = step("grab_dribble", "aim", "the gap is {} deg to the left", {12.0});
  EXPECT_EQ(lineOf(aim), "grab_dribble: aim - the gap is 12 deg to the left");
  EXPECT_EQ(sentenceOf(aim), "The skill grab_dribble chose aim: the gap is 12 deg to the left.");
  EXPECT_EQ(sentenceOf(step("kick", "go", "")), "The skill kick chose go.");
}

TEST(TraceWords, WhoHasNoNameGoesByTheLayer) {
  EXPECT_EQ(lineOf(step("", "aim", "")), "skill: aim");
  EXPECT_EQ(sentenceOf(step("", "aim", "")), "The skill chose aim.");
}

TEST(TraceWords, APlaceInTheTreeIsNotSaid) {
  EXPECT_EQ(lineOf(step("tree 0nyy", "dribble", "defensive")), "tree: dribble - defensive");
}

TEST(TraceWords, AChainNamesAllThatWasChosen) {
  Trace trace;
  trace.push_back(step("forward", "play", "play is on"));
  trace.push_back(step("grab", "approach", "the ball is {} cm away", {50.0}));
  EXPECT_EQ(chainOf(trace), "forward: play > grab: approach");
  EXPECT_EQ(chainOf({}), "");
}

TEST(TraceWords, WhatIsNoTextIsNotPrinted) {
  EXPECT_EQ(lineOf(step("a\x1b[2J", "b\n", "\xff\xc3 caf\xc3\xa9 \xe2\x82")),
            "a?[2J: b? - ?? caf\xc3\xa9 ??");
}

TEST(TraceWords, TheRequestIsSaidInWords) {
  Command command;
  EXPECT_EQ(requestOf(command), "stand; look straight ahead");
  command.walk.forward = 40.0;
  command.walk.left = -3.0;
  command.walk.turn = Angle::deg(20.0).rad();
  command.head.headPan = Angle::deg(30.0);
  command.head.neckTilt = Angle::deg(-20.0);
  EXPECT_EQ(requestOf(command),
            "walk 40 cm/s ahead and 3 cm/s to the right and turn 20 deg/s to the left; "
            "look 30 deg to the left and 20 deg down");
  command.motion = MotionKind::upennLeft;
  EXPECT_EQ(requestOf(command), "play the motion upenn_left");
}

TEST(TraceWords, WhoDecidedInPlaceOfTheBehavioursIsSaid) {
  Command command;
  command.trace.push_back(step("grab", "approach", ""));
  EXPECT_EQ(reasonLines(false, command), (std::vector<std::string>{"grab: approach"}));
  EXPECT_EQ(reasonLines(true, command), (std::vector<std::string>{"a person drives the robot"}));
  command.fallback = Fallback::timeLimit;
  EXPECT_EQ(insteadOf(false, command),
            "the behaviours took too long, so the robot stands and looks left and right");
}

}  // namespace
}  // namespace kelpie::match
