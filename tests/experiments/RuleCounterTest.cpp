// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "tools/experiments/team/RuleCounter.h"

namespace kelpie::experiments {
namespace {

Rule rule(std::vector<std::string> steps) { return {"A-1", "a rule", std::move(steps), "", ""}; }

Trace traceOf(const std::vector<std::vector<std::string>>& steps) {
  Trace trace;
  for (const auto& step : steps) {
    TraceStep said;
    said.module.assign(step[0]);
    said.branch.assign(step[1]);
    said.reason.assign(step[2]);
    trace.push_back(said);
  }
  return trace;
}

const Trace kSpin = traceOf(
    {{"attacker", "find", "ball unseen for {} frames"}, {"find_ball", "spin", "once round"}});
const Trace kTree = traceOf({{"tree 0nn", "grab_turn_kick", "defensive; contested; to the left"}});

TEST(RuleCounter, WhatGoesOnWasPlayedOnce) {
  RuleCounter counter({rule({"find_ball/spin"})});
  for (int i = 0; i < 3; ++i) counter.frame(kSpin);
  EXPECT_EQ(counter.plays()[0].times, 1);
  EXPECT_EQ(counter.plays()[0].frames, 3);
}

TEST(RuleCounter, WhatIsLeftAndBegunAgainWasPlayedTwice) {
  RuleCounter counter({rule({"find_ball/spin"})});
  counter.frame(kSpin);
  counter.frame(kTree);
  counter.frame(kSpin);
  EXPECT_EQ(counter.plays()[0].times, 2);
}

TEST(RuleCounter, AnotherRobotBeginsAnew) {
  RuleCounter counter({rule({"find_ball/spin"})});
  counter.frame(kSpin);
  counter.beginRobot();
  counter.frame(kSpin);
  EXPECT_EQ(counter.plays()[0].times, 2);
}

TEST(RuleCounter, AnyOfItsStepsIsTheRuleInAnyPlaceOfTheTrace) {
  RuleCounter counter({rule({"goalie/block", "find_ball/spin"}), rule({"attacker/find"})});
  counter.frame(kSpin);
  EXPECT_EQ(counter.plays()[0].times, 1);
  EXPECT_EQ(counter.plays()[1].times, 1);
}

TEST(RuleCounter, AStarStandsForTheEndOfAPart) {
  RuleCounter counter({rule({"tree */grab*/defensive; contested*"}), rule({"tree */grab*/middle*"}),
                       rule({"tree/*"}), rule({"*"})});
  counter.frame(kTree);
  EXPECT_EQ(counter.plays()[0].times, 1);
  EXPECT_EQ(counter.plays()[1].times, 0);
  EXPECT_EQ(counter.plays()[2].times, 0);
  EXPECT_EQ(counter.plays()[3].times, 1);
}

TEST(RuleCounter, AReasonIsWantedWhole) {
  RuleCounter counter({rule({"find_ball/spin/once"}), rule({"find_ball/spin/once round"})});
  counter.frame(kSpin);
  EXPECT_EQ(counter.plays()[0].times, 0);
  EXPECT_EQ(counter.plays()[1].times, 1);
}

TEST(RuleCounter, ARowWithoutStepsIsNeverPlayed) {
  RuleCounter counter({rule({})});
  counter.frame(kSpin);
  EXPECT_EQ(counter.plays()[0].frames, 0);
}

}  // namespace
}  // namespace kelpie::experiments
