// SPDX-License-Identifier: Apache-2.0
// What a person who watches may order, in words.
#include <gtest/gtest.h>

#include <random>

#include "tools/sim/staging/LiveOrder.h"

namespace kelpie::sim {
namespace {

const std::vector<host::AgentHello> kRobots = {{TeamColour::red, 1}, {TeamColour::blue, 4}};

Status checked(const std::string& words) {
  const auto order = liveOrderFrom(words);
  if (!order) return Error{order.error()};
  return checkOrder(*body::fieldDescription("2006"), kRobots, *order);
}

TEST(LiveOrder, WordsMeanTheSameAgain) {
  for (const char* words :
       {"pause", "resume", "step 1", "step 3000", "speed 0", "speed 0.25", "speed 100", "ball 0,0",
        "ball 12.5,-3", "carry red:1:180,100.5,90", "carry blue:4:20,30,-45"}) {
    const auto order = liveOrderFrom(words);
    ASSERT_TRUE(order) << order.error();
    EXPECT_EQ(wordsFor(*order), words);
  }
}

TEST(LiveOrder, PlacesKeepEveryBit) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> place(-1000.0, 1000.0);
  for (int i = 0; i < 1000; ++i) {
    LiveOrder order;
    order.kind = LiveOrder::Kind::ball;
    order.ball = {place(random), place(random)};
    const auto again = liveOrderFrom(wordsFor(order));
    ASSERT_TRUE(again) << again.error();
    EXPECT_EQ(again->ball.x, order.ball.x);
    EXPECT_EQ(again->ball.y, order.ball.y);
  }
}

TEST(LiveOrder, WhatIsNoOrderIsRefusedInOneLineWithItsWords) {
  for (const std::string& words : {std::string(),
                                   std::string(" "),
                                   std::string("Pause"),
                                   std::string("pause "),
                                   std::string("pause now"),
                                   std::string("pause\nresume"),
                                   std::string("halt"),
                                   std::string("carry"),
                                   std::string("ball"),
                                   std::string("step"),
                                   std::string("step "),
                                   std::string("step 0"),
                                   std::string("step -1"),
                                   std::string("step 3001"),
                                   std::string("step 1.5"),
                                   std::string("step 99999999999"),
                                   std::string("step 1 1"),
                                   std::string("speed"),
                                   std::string("speed -1"),
                                   std::string("speed 101"),
                                   std::string("speed nan"),
                                   std::string("speed inf"),
                                   std::string("speed fast"),
                                   std::string("ball 1"),
                                   std::string("ball 1,2,3"),
                                   std::string("ball nan,2"),
                                   std::string("ball 1;2"),
                                   std::string("ball 1,2 "),
                                   std::string("carry red:1"),
                                   std::string("carry red:1:1,2"),
                                   std::string("carry red:5:1,2,3"),
                                   std::string("carry green:1:1,2,3"),
                                   std::string("carry red:1:1,2,inf"),
                                   std::string("carry red:1:1,2,3:4")}) {
    const auto order = liveOrderFrom(words);
    ASSERT_FALSE(order) << words;
    EXPECT_NE(order.error().find("'"), std::string::npos) << order.error();
  }
}

TEST(LiveOrder, PlacesOffTheFieldAndInThingsAreRefused) {
  EXPECT_TRUE(checked("ball 0,0"));
  EXPECT_TRUE(checked("ball 360,540"));
  EXPECT_TRUE(checked("carry red:1:180,270,0"));
  for (const char* words : {"ball -1,100", "ball 100,541", "ball 1e6,1e6", "carry red:1:-1,100,0",
                            "carry red:1:180,541,0", "carry red:1:140,539,90"})
    EXPECT_FALSE(checked(words)) << words;
}

TEST(LiveOrder, ARobotThatDoesNotPlayIsNotCarried) {
  for (const char* words : {"carry red:2:180,270,0", "carry blue:1:180,270,0"})
    EXPECT_NE(checked(words).error().find("is there to be carried"), std::string::npos) << words;
}

TEST(LiveOrder, PauseResumeStepAndSpeedAlwaysCanBeObeyed) {
  for (const char* words : {"pause", "resume", "step 10", "speed 2"})
    EXPECT_TRUE(checked(words)) << words;
}

}  // namespace
}  // namespace kelpie::sim
