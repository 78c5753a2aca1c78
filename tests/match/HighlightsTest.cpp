// SPDX-License-Identifier: Apache-2.0
// What happened in a match, and which moments stand for it.
#include <gtest/gtest.h>

#include <memory>

#include "tools/match/Highlights.h"

namespace kelpie::match {
namespace {

Happening at(HappeningKind kind, double seconds) {
  return {kind, static_cast<std::size_t>(30.0 * seconds), seconds, "words"};
}

// A minute in which this happened, from its first frame to its last.
std::vector<Happening> minuteWith(std::vector<Happening> inside) {
  inside.insert(inside.begin(), at(HappeningKind::begin, 0.0));
  inside.push_back(at(HappeningKind::end, 60.0));
  return inside;
}

int count(const std::vector<Happening>& chosen, HappeningKind kind) {
  int found = 0;
  for (const Happening& one : chosen) found += one.kind == kind ? 1 : 0;
  return found;
}

TEST(Highlights, AreEvenTimesWhereNothingHappened) {
  const auto chosen = chooseHighlights(minuteWith({}), 6);
  ASSERT_EQ(chosen.size(), 6U);
  for (std::size_t i = 0; i < 6; ++i)
    EXPECT_NEAR(chosen[i].seconds, 12.0 * static_cast<double>(i), 0.1);
}

TEST(Highlights, HaveEveryGoalEvenWhereMuchElseHappened) {
  std::vector<Happening> much;
  for (int i = 1; i < 50; ++i) {
    much.push_back(at(HappeningKind::kick, i));
    if (i == 20 || i == 40) much.push_back(at(HappeningKind::goal, i + 0.5));
  }
  const auto chosen = chooseHighlights(minuteWith(much), 6);
  EXPECT_EQ(chosen.size(), 6U);
  EXPECT_EQ(count(chosen, HappeningKind::goal), 2);
}

TEST(Highlights, PreferTheFirstOfAKindToItsRepetition) {
  const auto chosen =
      chooseHighlights(minuteWith({at(HappeningKind::kick, 10), at(HappeningKind::kick, 20),
                                   at(HappeningKind::kick, 30), at(HappeningKind::sight, 40)}),
                       2);
  ASSERT_EQ(chosen.size(), 2U);
  EXPECT_EQ(chosen[0].seconds, 10.0);
  EXPECT_EQ(chosen[1].kind, HappeningKind::sight);
}

TEST(Highlights, StandInTheOrderOfTimeAndApart) {
  const auto chosen =
      chooseHighlights(minuteWith({at(HappeningKind::sight, 5), at(HappeningKind::hold, 30),
                                   at(HappeningKind::kick, 30.5), at(HappeningKind::goal, 50)}),
                       6);
  ASSERT_EQ(chosen.size(), 6U);
  for (std::size_t i = 1; i < chosen.size(); ++i)
    EXPECT_GT(chosen[i].seconds - chosen[i - 1].seconds, 2.0);
}

TEST(Highlights, OfFewFramesAreAllOfThem) {
  const std::vector<Happening> three = {{HappeningKind::begin, 0, 0.0, ""},
                                        {HappeningKind::end, 2, 0.067, ""}};
  EXPECT_LE(chooseHighlights(three, 6).size(), 3U);
  EXPECT_TRUE(chooseHighlights({}, 6).empty());
}

class HappeningsTest : public testing::Test {
 protected:
  void frame(double seconds) {
    input_->time = TimeUs{static_cast<std::int64_t>(1e6 * seconds)};
    happenings_->take({*input_, *output_, {}});
  }
  void begin(const std::vector<sim::MatchEvent>& events) {
    happenings_ = std::make_unique<Happenings>(events);
  }
  int count(HappeningKind kind) { return match::count(happenings_->all(), kind); }

  std::unique_ptr<FrameInput> input_ = std::make_unique<FrameInput>();
  std::unique_ptr<FrameOutput> output_ = std::make_unique<FrameOutput>();
  std::unique_ptr<Happenings> happenings_ =
      std::make_unique<Happenings>(std::vector<sim::MatchEvent>{});
};

TEST_F(HappeningsTest, TheBallIsSeenForTheFirstTimeOnce) {
  output_->percepts.ball.present = true;
  output_->percepts.ball.distance = 83.0;
  for (int i = 0; i < 5; ++i) frame(0.1 * i);
  const auto all = happenings_->all();
  EXPECT_EQ(match::count(all, HappeningKind::sight), 1);
  EXPECT_EQ(all[1].words, "First sight of the ball: 83 cm away, straight ahead.");
}

TEST_F(HappeningsTest, AHoldThatFlickersIsOne) {
  for (int i = 0; i < 20; ++i) {
    input_->motion.feeling.ballHeld = i % 2 == 0;
    frame(0.1 * i);
  }
  EXPECT_EQ(count(HappeningKind::hold), 1);
}

TEST_F(HappeningsTest, AKickIsToldWhenItBegins) {
  frame(0.0);
  input_->motion.running = MotionKind::kickForward;
  frame(0.1);
  frame(0.2);
  input_->motion.running = MotionKind::none;
  frame(0.3);
  EXPECT_EQ(count(HappeningKind::kick), 1);
}

TEST_F(HappeningsTest, TheGoalThatEndsAMatchIsShownShortlyBeforeIt) {
  sim::MatchEvent goal;
  goal.kind = sim::EventKind::goal;
  goal.time = TimeUs{5000000};
  begin({goal});
  for (int i = 0; i < 100; ++i) frame(i / 30.0);
  const auto all = happenings_->all();
  ASSERT_EQ(match::count(all, HappeningKind::goal), 1);
  const auto found = std::find_if(
      all.begin(), all.end(), [](const Happening& one) { return one.kind == HappeningKind::goal; });
  EXPECT_EQ(found->words, "Goal of red.");
  EXPECT_LT(found->frame, 99U);
}

}  // namespace
}  // namespace kelpie::match
