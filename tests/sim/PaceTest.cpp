// SPDX-License-Identifier: Apache-2.0
// How fast a match goes and when it stands. Nothing here fails because a machine is slow: a wait
// is only ever asked to be long enough.
#include <gtest/gtest.h>

#include <thread>

#include "tools/sim/world/Pace.h"

namespace kelpie::sim {
namespace {

using Clock = std::chrono::steady_clock;
using std::chrono::milliseconds;

TEST(Pace, WithoutASpeedNothingIsWaitedForAndOrdersAreHeardOnceAStep) {
  Pace pace(0.0);
  int heard = 0;
  for (int i = 0; i < 1000; ++i) pace.await(TimeUs{1000000LL * i}, [&] { ++heard; }, {});
  EXPECT_EQ(heard, 1000);
}

TEST(Pace, AStandingMatchHearsUntilItIsResumed) {
  Pace pace(0.0);
  pace.pause();
  EXPECT_TRUE(pace.paused());
  int heard = 0;
  pace.await(
      TimeUs{8000},
      [&] {
        if (++heard == 4) pace.resume();
      },
      [] { return false; });
  EXPECT_EQ(heard, 4);
  EXPECT_FALSE(pace.paused());
}

TEST(Pace, AStandingMatchEndsWhenItIsStopped) {
  Pace pace(1.0);
  pace.pause();
  int asked = 0;
  pace.await(
      TimeUs{8000}, [] {}, [&] { return ++asked == 3; });
  EXPECT_EQ(asked, 3);
}

TEST(Pace, AnOrderToPauseCountsForTheStepThatHearsIt) {
  Pace pace(0.0);
  bool stood = false;
  pace.await(
      TimeUs{8000}, [&] { pace.pause(); }, [&] { return stood = true; });
  EXPECT_TRUE(stood);
}

// Images are there at whole thirtieths of a second; ticks need not meet them.
TEST(Pace, AStepHasSoManyImagesAndThenItStandsAgain) {
  Pace pace(0.0);
  std::int64_t image = 1;
  pace.pause();
  for (const int images : {1, 3, 30}) {
    pace.step(images);
    int passed = 0;
    bool stood = false;
    while (!stood) {
      pace.await(
          TimeUs{image * 1000000 / 30}, [] {}, [&] { return stood = true; });
      if (!stood) ++passed, ++image;
    }
    EXPECT_EQ(passed, images);
    EXPECT_TRUE(pace.paused());
  }
}

TEST(Pace, BetweenImagesTimeGoesOnWithoutCounting) {
  Pace pace(0.0);
  pace.step(1);
  bool stood = false;
  for (const std::int64_t us : {34000, 42000, 50000, 66666})
    pace.await(
        TimeUs{us}, [] {}, [&] { return stood = true; });
  EXPECT_FALSE(stood);
  pace.await(
      TimeUs{66667}, [] {}, [&] { return stood = true; });
  EXPECT_TRUE(stood);
}

TEST(Pace, StepsAddUpAndAPauseEndsThem) {
  Pace pace(0.0);
  bool stood = false;
  const auto pass = [&](std::int64_t image) {
    stood = false;
    pace.await(
        TimeUs{image * 1000000 / 30}, [] {}, [&] { return stood = true; });
    return !stood;
  };
  pace.step(1);
  pace.step(2);
  EXPECT_TRUE(pass(1) && pass(2) && pass(3));
  EXPECT_FALSE(pass(4));
  pace.step(3000);
  EXPECT_TRUE(pass(4));
  pace.pause();
  EXPECT_FALSE(pass(5));
}

TEST(Pace, AMatchThatIsResumedHasForgottenItsSteps) {
  Pace pace(0.0);
  pace.step(3000);
  pace.resume();
  pace.await(TimeUs{8000}, [] {}, {});
  pace.pause();
  bool stood = false;
  pace.await(
      TimeUs{16000}, [] {}, [&] { return stood = true; });
  EXPECT_TRUE(stood);
}

TEST(Pace, ByTheClockItTakesAtLeastItsTime) {
  Pace pace(2.0);
  const auto start = Clock::now();
  for (int i = 0; i <= 20; ++i) pace.await(TimeUs{8000 * i}, [] {}, {});
  EXPECT_GE(Clock::now() - start, milliseconds(80));
}

TEST(Pace, AfterAStallItDoesNotCatchUp) {
  Pace pace(1.0);
  pace.await(TimeUs{0}, [] {}, {});
  std::this_thread::sleep_for(milliseconds(350));
  pace.await(TimeUs{8000}, [] {}, {});
  const auto start = Clock::now();
  pace.await(TimeUs{68000}, [] {}, {});
  EXPECT_GE(Clock::now() - start, milliseconds(50));
}

TEST(Pace, WhatWasPausedIsNotCaughtUpWith) {
  Pace pace(1.0);
  pace.await(TimeUs{0}, [] {}, {});
  pace.pause();
  std::this_thread::sleep_for(milliseconds(150));
  pace.resume();
  pace.await(TimeUs{8000}, [] {}, {});
  const auto start = Clock::now();
  pace.await(TimeUs{68000}, [] {}, {});
  EXPECT_GE(Clock::now() - start, milliseconds(50));
}

TEST(Pace, HoweverSlowItHearsThatItShallBeFasterOrStop) {
  for (const double slow : {1e-3, 1e-12, 5e-324}) {
    Pace pace(slow);
    pace.await(TimeUs{0}, [] {}, {});
    int heard = 0;
    pace.await(TimeUs{1000000},
               [&] {
                 if (++heard == 3) pace.setSpeed(0.0);
               },
               {});
    EXPECT_EQ(heard, 3) << slow;
    pace.setSpeed(slow);
    pace.await(TimeUs{1000000}, [] {}, {});
    int asked = 0;
    pace.await(
        TimeUs{2000000}, [] {}, [&] { return ++asked == 3; });
    EXPECT_EQ(asked, 3) << slow;
  }
}

}  // namespace
}  // namespace kelpie::sim
