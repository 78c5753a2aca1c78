// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <atomic>
#include <mutex>
#include <set>
#include <stdexcept>

#include "tests/league/RandomPlay.h"
#include "tools/league/Run.h"
#include "tools/league/Table.h"

namespace kelpie::league {
namespace {

// A journal in a folder of the running test's own.
Expected<LeagueJournal> freshJournal(const std::string& name = "") {
  const auto* test = testing::UnitTest::GetInstance()->current_test_info();
  return LeagueJournal::open(testing::TempDir() + "/run-" + test->name() + name, smallPlan());
}

MatchResult troubled(const std::string& trouble) {
  MatchResult result;
  result.trouble = trouble;
  return result;
}

TEST(Run, PlaysEachMatchOnceOnAnyNumberOfThreads) {
  std::set<std::string> texts;
  for (const int workers : {0, 1, 5, 40}) {
    auto journal = freshJournal(std::to_string(workers));
    std::atomic<int> played{0};
    const Play play = [&played](const LeagueMatch& match) {
      ++played;
      return RandomPlay{}(match);
    };
    const auto summary = runLeague(*journal, play, workers);
    ASSERT_TRUE(summary.ok()) << summary.error();
    EXPECT_EQ(summary->played, 12U);
    EXPECT_FALSE(summary->stopped);
    EXPECT_EQ(played, 12);
    texts.insert(textOf(standingsOf({journal->plan(), journal->results()})));
  }
  EXPECT_EQ(texts.size(), 1U);
}

TEST(Run, AMatchInTroubleIsTriedOnceMoreThenVoidAndReported) {
  auto journal = freshJournal();
  int tries = 0;
  const Play play = [&tries](const LeagueMatch& match) {
    if (match.red != "b" || match.blue != "c" || match.seed != 8) return RandomPlay{}(match);
    return troubled("try " + std::to_string(++tries));
  };
  std::vector<std::string> reported;
  RunTalk talk;
  talk.again = [&](std::size_t, const std::string& trouble) { reported.push_back(trouble); };
  const auto summary = runLeague(*journal, play, 3, talk);
  EXPECT_EQ(tries, 2);
  EXPECT_EQ(reported, std::vector<std::string>{"try 1"});
  EXPECT_EQ(summary->voids, 1U);
  const Standings standings = standingsOf({journal->plan(), journal->results()});
  ASSERT_EQ(standings.troubles.size(), 1U);
  EXPECT_EQ(standings.troubles[0], "match 10, red b, blue c, seed 8: try 2");
  EXPECT_EQ(standings.unpaired, 1U);
  EXPECT_EQ(standings.counted, 10U);
}

TEST(Run, AMatchThatGoesWellTheSecondTimeCounts) {
  auto journal = freshJournal();
  int tries = 0;
  const Play play = [&tries](const LeagueMatch& match) {
    return ++tries % 2 == 1 ? troubled("now and then") : RandomPlay{}(match);
  };
  EXPECT_EQ(runLeague(*journal, play, 1)->voids, 0U);
  EXPECT_EQ(tries, 24);
}

TEST(Run, WhatIsThrownAndWhatCannotBeIsTrouble) {
  auto journal = freshJournal();
  const Play play = [](const LeagueMatch& match) {
    if (match.red == "a") throw std::runtime_error("thrown");
    MatchResult result;
    if (match.red == "b") result.redOwnGoals = 1;  // which blue's goals do not hold
    return result;
  };
  EXPECT_EQ(runLeague(*journal, play, 2)->voids, 8U);
  EXPECT_EQ(journal->results()[0]->trouble, "thrown");
  EXPECT_EQ(journal->results()[1]->trouble, "an impossible result");
}

TEST(Run, StopsPolitelyAndGoesOnLater) {
  auto journal = freshJournal();
  std::atomic<int> played{0};
  RunTalk talk;
  talk.stop = [&played] { return played >= 5; };
  const Play play = [&played](const LeagueMatch& match) {
    ++played;
    return RandomPlay{}(match);
  };
  const auto summary = runLeague(*journal, play, 1, talk);
  EXPECT_TRUE(summary->stopped);
  EXPECT_EQ(summary->played, 5U);
  EXPECT_EQ(summary->left, 7U);
  EXPECT_EQ(runLeague(*journal, play, 2)->played, 7U);
}

TEST(Run, AMatchCutShortByTheRequestToStopIsNotKept) {
  auto journal = freshJournal();
  std::atomic<bool> stop{false};
  std::atomic<int> tries{0};
  RunTalk talk;
  talk.stop = [&stop] { return stop.load(); };
  const Play play = [&](const LeagueMatch&) {
    ++tries;
    stop = true;
    return troubled("interrupted");
  };
  EXPECT_EQ(runLeague(*journal, play, 1, talk)->left, 12U);
  EXPECT_EQ(tries, 1);
  EXPECT_FALSE(journal->results()[0]);
}

}  // namespace
}  // namespace kelpie::league
