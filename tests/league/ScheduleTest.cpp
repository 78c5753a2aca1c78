// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <limits>
#include <map>
#include <tuple>

#include "tests/league/RandomPlay.h"

namespace kelpie::league {
namespace {

TEST(Schedule, EachPairPlaysEachSeedOnceInEitherColours) {
  std::map<std::tuple<std::string, std::string, std::uint64_t>, int> times;
  for (const auto& scheduled : scheduleOf(smallPlan()))
    ++times[{scheduled.match.red, scheduled.match.blue, scheduled.match.seed}];
  EXPECT_EQ(times.size(), 12U);
  for (const char* red : {"a", "b", "c"})
    for (const char* blue : {"a", "b", "c"})
      for (const std::uint64_t seed : {7U, 8U})
        EXPECT_EQ((times[{red, blue, seed}]), std::string(red) == blue ? 0 : 1);
}

TEST(Schedule, TheMatchesOfASeedStandSideBySideAndSeedsOutermost) {
  const auto schedule = scheduleOf(smallPlan());
  for (std::size_t i = 0; i < schedule.size(); i += 2) {
    EXPECT_FALSE(schedule[i].exchanged);
    EXPECT_TRUE(schedule[i + 1].exchanged);
    EXPECT_EQ(schedule[i].match.red, schedule[i + 1].match.blue);
    EXPECT_EQ(schedule[i].match.seed, schedule[i + 1].match.seed);
    EXPECT_EQ(schedule[i].draw, i < 6 ? 0 : 1);
  }
}

TEST(Schedule, AgainstAReferenceOnlyItsPairsPlay) {
  LeaguePlan plan = smallPlan();
  plan.reference = "b";
  const auto pairings = pairingsOf(plan);
  ASSERT_EQ(pairings.size(), 2U);
  EXPECT_EQ(plan.sides[pairings[0].second], "b");
  EXPECT_EQ(plan.sides[pairings[1].first], "b");
}

TEST(Schedule, WhatCannotBePlayedIsRefusedInOneLine) {
  const auto refused = [](const std::function<void(LeaguePlan&)>& spoil) {
    LeaguePlan plan = smallPlan();
    spoil(plan);
    const Status status = checkPlan(plan);
    return !status && !status.error().empty() && status.error().find('\n') == std::string::npos;
  };
  EXPECT_TRUE(checkPlan(smallPlan()).ok());
  EXPECT_TRUE(refused([](LeaguePlan& plan) { plan.sides = {"a"}; }));
  EXPECT_TRUE(refused([](LeaguePlan& plan) { plan.sides = {"a", "a"}; }));
  EXPECT_TRUE(refused([](LeaguePlan& plan) { plan.sides = {"a", ""}; }));
  EXPECT_TRUE(refused([](LeaguePlan& plan) { plan.sides = {"a", " b"}; }));
  EXPECT_TRUE(refused([](LeaguePlan& plan) { plan.reference = "d"; }));
  EXPECT_TRUE(refused([](LeaguePlan& plan) { plan.matchesAPair = 3; }));
  EXPECT_TRUE(refused([](LeaguePlan& plan) { plan.matchesAPair = 0; }));
  EXPECT_TRUE(refused([](LeaguePlan& plan) { plan.minutes = 0.0; }));
  EXPECT_TRUE(
      refused([](LeaguePlan& plan) { plan.minutes = std::numeric_limits<double>::quiet_NaN(); }));
  EXPECT_TRUE(refused([](LeaguePlan& plan) { plan.seed = ~0ULL; }));
}

}  // namespace
}  // namespace kelpie::league
