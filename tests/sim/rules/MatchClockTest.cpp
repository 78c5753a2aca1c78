// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "tools/sim/rules/MatchClock.h"

namespace kelpie::sim {
namespace {

constexpr auto kRed = TeamColour::red;
constexpr auto kBlue = TeamColour::blue;

struct Watch {
  body::Rules rules;
  ClockState clock = clockFor(kRed);
  ClockIn in;
  std::vector<EventKind> seen;

  void tick() {
    in.time = in.time + TimeUs{kTickUs};
    if (const auto kind = step(in, rules, clock)) seen.push_back(*kind);
    in.goalFor.reset();
  }
  // Ticks until something begins; how many seconds that took.
  double untilNext() {
    const std::size_t before = seen.size();
    const TimeUs from = in.time;
    while (seen.size() == before && (in.time - from).seconds() < 1000.0) tick();
    return (in.time - from).seconds();
  }
};

TEST(MatchClock, AKickOffTakesInitialReadyAndSet) {
  Watch watch;
  EXPECT_NEAR(watch.untilNext(), 5.0, 0.01);
  EXPECT_EQ(watch.clock.state, PlayState::ready);
  EXPECT_NEAR(watch.untilNext(), 45.0, 0.01);
  EXPECT_EQ(watch.clock.state, PlayState::set);
  EXPECT_NEAR(watch.untilNext(), 3.0, 0.01);
  EXPECT_EQ(watch.clock.state, PlayState::playing);
}

TEST(MatchClock, ReadyEndsWhenAllPlacesAreTaken) {
  Watch watch;
  watch.untilNext();
  watch.in.placesTaken = true;
  watch.tick();
  EXPECT_EQ(watch.clock.state, PlayState::set);
}

TEST(MatchClock, AfterAGoalTheOtherTeamKicksOff) {
  for (const TeamColour scores : {kRed, kBlue}) {
    Watch watch;
    for (int i = 0; i < 3; ++i) watch.untilNext();
    watch.in.goalFor = scores;
    watch.tick();
    EXPECT_EQ(watch.clock.state, PlayState::ready);
    EXPECT_EQ(watch.clock.kickOff, otherTeam(scores));
  }
}

TEST(MatchClock, OnlyPlayCountsForTheHalf) {
  Watch watch;
  for (int i = 0; i < 3; ++i) watch.untilNext();
  EXPECT_NEAR(watch.clock.secondsLeft(watch.rules), 600.0, 0.01);
  for (int i = 0; i < 1250; ++i) watch.tick();
  watch.in.goalFor = kBlue;
  watch.tick();
  EXPECT_NEAR(watch.clock.secondsLeft(watch.rules), 45.0, 0.01) << "of ready";
  watch.untilNext();
  EXPECT_NEAR(watch.clock.secondsLeft(watch.rules), 590.0, 0.02);
  watch.untilNext();
  EXPECT_NEAR(watch.clock.secondsLeft(watch.rules), 590.0, 0.02);
  EXPECT_NEAR(watch.untilNext(), 590.0, 0.02);
  EXPECT_EQ(watch.seen.back(), EventKind::half);
}

TEST(MatchClock, TwoHalvesAndTheOtherTeamsKickOffInTheSecond) {
  Watch watch;
  for (int i = 0; i < 4; ++i) watch.untilNext();
  EXPECT_FALSE(watch.clock.firstHalf);
  EXPECT_EQ(watch.clock.state, PlayState::initial);
  EXPECT_EQ(watch.clock.kickOff, kBlue);
  for (int i = 0; i < 4; ++i) watch.untilNext();
  EXPECT_EQ(watch.clock.state, PlayState::finished);
  EXPECT_EQ(watch.clock.secondsLeft(watch.rules), 0.0);
  const std::vector<EventKind> one{EventKind::ready, EventKind::set, EventKind::play};
  std::vector<EventKind> both = one;
  both.push_back(EventKind::half);
  both.insert(both.end(), one.begin(), one.end());
  both.push_back(EventKind::end);
  EXPECT_EQ(watch.seen, both);
  EXPECT_NEAR(watch.in.time.seconds(), 2.0 * (5.0 + 45.0 + 3.0 + 600.0), 0.2);
}

TEST(MatchClock, AGoalInTheLastTickEndsTheHalf) {
  Watch watch;
  for (int i = 0; i < 3; ++i) watch.untilNext();
  while (watch.clock.played.seconds() < watch.rules.halfTime - 1.5 * kTickSeconds) watch.tick();
  watch.in.goalFor = kRed;
  watch.tick();
  EXPECT_EQ(watch.seen.back(), EventKind::half);
  EXPECT_EQ(watch.clock.kickOff, kBlue);
}

}  // namespace
}  // namespace kelpie::sim
