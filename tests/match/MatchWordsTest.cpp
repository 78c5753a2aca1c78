// SPDX-License-Identifier: Apache-2.0
// The words over a match's pictures, and what paths are drawn.
#include <gtest/gtest.h>

#include "tools/match/MatchWords.h"
#include "tools/match/drawing/FieldDrawing.h"

namespace kelpie::match {
namespace {

MatchFacts facts(int reds, int blues) {
  MatchFacts made = factsOf({{"red", "kelpie"}, {"seed", "7"}}, TeamColour::red, 1);
  made.scored = true;
  made.reds = reds;
  made.blues = blues;
  made.seconds = 83.4;
  return made;
}

sim::MatchEvent goalOf(TeamColour team, double seconds) {
  sim::MatchEvent event;
  event.kind = sim::EventKind::goal;
  event.team = team;
  event.time = TimeUs{static_cast<std::int64_t>(1e6 * seconds)};
  return event;
}

TEST(MatchWords, NameTheTeamsThatTheLogKnows) {
  EXPECT_EQ(nameOf(facts(1, 0), TeamColour::red), "kelpie");
  EXPECT_EQ(nameOf(facts(1, 0), TeamColour::blue), "empty goal");
  EXPECT_EQ(nameOf(facts(4, 4), TeamColour::blue), "blue");
}

TEST(MatchWords, TellSidesTimeAndSeed) {
  EXPECT_EQ(subtitleOf(facts(4, 4)), "Four robots against four · 1:23.4 · seed 7");
  EXPECT_EQ(subtitleOf(facts(1, 0)), "One robot and an empty goal · 1:23.4 · seed 7");
  MatchFacts unknown = factsOf({}, TeamColour::blue, 3);
  EXPECT_EQ(subtitleOf(unknown), "A recording of one robot · 0:00.0");
  EXPECT_EQ(scoreOf(unknown), "-");
}

TEST(MatchWords, CountTheGoalsThatHaveFallenUntilThen) {
  MatchFacts made = facts(1, 1);
  const std::vector<sim::MatchEvent> events = {
      goalOf(TeamColour::red, 10), goalOf(TeamColour::blue, 20), goalOf(TeamColour::red, 30)};
  score(events, TimeUs{20000000}, made);
  EXPECT_EQ(scoreOf(made), "1 : 1");
  score(events, TimeUs{40000000}, made);
  EXPECT_EQ(scoreOf(made), "2 : 1");
}

TEST(MatchWords, ClocksNeverShowSixtySeconds) {
  EXPECT_EQ(clockOf(59.96), "1:00.0");
  EXPECT_EQ(clockOf(0.0), "0:00.0");
  EXPECT_EQ(clockOf(725.04), "12:05.0");
}

TEST(Paths, AreBrokenWhereSomebodyWasCarried) {
  const TimedPath path = {{0.0, {0, 0}}, {0.1, {3, 0}}, {0.2, {200, 0}}, {0.3, {203, 0}}};
  const auto pieces = unbroken(path, 120.0);
  ASSERT_EQ(pieces.size(), 2U);
  EXPECT_EQ(pieces[1].front().place.x, 200.0);
}

TEST(Paths, HaveAsManyTimeMarksAsCanBeRead) {
  EXPECT_EQ(timeBetweenMarks(29.0, 10), 5.0);
  EXPECT_EQ(timeBetweenMarks(600.0, 10), 60.0);
  TimedPath path;
  for (int i = 0; i <= 120; ++i) path.push_back({0.1 * i, {static_cast<double>(i), 0.0}});
  const TimedPath marks = timeMarks(path, 5.0);
  ASSERT_EQ(marks.size(), 2U);
  EXPECT_NEAR(marks[0].place.x, 50.0, 1.0);
}

TEST(Badges, StandApartFromEachOther) {
  const std::vector<picture::Spot> spots = {{100, 100}, {102, 100}, {104, 102}};
  const auto beside = besideEach(spots, 24.0);
  for (std::size_t i = 0; i < beside.size(); ++i)
    for (std::size_t k = 0; k < i; ++k)
      EXPECT_GT(std::hypot(beside[i].x - beside[k].x, beside[i].y - beside[k].y), 20.0);
}

}  // namespace
}  // namespace kelpie::match
