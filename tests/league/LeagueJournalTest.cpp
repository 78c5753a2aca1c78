// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "tests/league/RandomPlay.h"
#include "tools/league/Run.h"
#include "tools/league/Table.h"

namespace kelpie::league {
namespace {

std::string folder(const std::string& name) { return testing::TempDir() + "/" + name; }

std::string contents(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

void write(const std::string& path, const std::string& text) {
  std::filesystem::create_directories(std::filesystem::path(path).parent_path());
  std::ofstream(path, std::ios::binary) << text;
}

std::string refusal(const std::string& where, const LeaguePlan& plan) {
  const auto journal = LeagueJournal::open(where, plan);
  return journal ? "" : journal.error();
}

// Of a whole league.
std::string wholeJournal(const LeaguePlan& plan = smallPlan()) {
  const std::string where = folder("whole");
  std::filesystem::remove_all(where);
  auto journal = LeagueJournal::open(where, plan);
  EXPECT_TRUE(journal.ok()) << journal.error();
  EXPECT_TRUE(runLeague(*journal, RandomPlay{}, 1).ok());
  return contents(journalPath(where));
}

// How many whole lines of matches a part of a journal has.
std::size_t wholeMatches(const std::string& part) {
  const auto lines = static_cast<std::size_t>(std::count(part.begin(), part.end(), '\n'));
  return lines == 0 ? 0 : lines - 1;
}

TEST(LeagueJournal, GoesOnAfterAKillAtAnyByteAndPlaysNoMatchTwice) {
  LeaguePlan plan = smallPlan();
  plan.sides = {"a", "b"};
  const std::string whole = wholeJournal(plan);
  const std::string where = folder("cut");
  for (std::size_t bytes = 0; bytes <= whole.size(); ++bytes) {
    const std::string part = whole.substr(0, bytes);
    write(journalPath(where), part);
    std::size_t played = 0;
    const Play play = [&played](const LeagueMatch& match) {
      ++played;
      return RandomPlay{}(match);
    };
    auto journal = LeagueJournal::open(where, plan);
    ASSERT_TRUE(journal.ok()) << bytes << ": " << journal.error();
    ASSERT_TRUE(runLeague(*journal, play, 1).ok());
    ASSERT_EQ(played, 4 - wholeMatches(part)) << bytes;
    ASSERT_EQ(contents(journalPath(where)), whole) << bytes;
  }
}

TEST(LeagueJournal, OfAKilledProcessIsGoneOnWith) {
  const std::string where = folder("killed");
  const pid_t child = fork();
  if (child == 0) {
    int played = 0;
    auto journal = LeagueJournal::open(where, smallPlan());
    runLeague(
        *journal,
        [&played](const LeagueMatch& match) {
          if (++played == 6) raise(SIGKILL);
          return RandomPlay{}(match);
        },
        1);
    _exit(1);
  }
  int status = 0;
  waitpid(child, &status, 0);
  ASSERT_TRUE(WIFSIGNALED(status));
  auto journal = LeagueJournal::open(where, smallPlan());
  ASSERT_TRUE(journal.ok()) << journal.error();
  const auto summary = runLeague(*journal, RandomPlay{}, 2);
  ASSERT_TRUE(summary.ok());
  EXPECT_EQ(summary->played, 7U);
  EXPECT_EQ(summary->left, 0U);
}

TEST(LeagueJournal, OfAnotherLeagueIsRefusedInOneLineAndLeftAsItIs) {
  const std::string whole = wholeJournal();
  LeaguePlan other = smallPlan();
  other.minutes = 5.0;
  EXPECT_EQ(refusal(folder("whole"), other),
            journalPath(folder("whole")) +
                ": the journal of another league (minutes 10.0 there, 5.0 asked for)");
  other = smallPlan();
  other.about = "another program";
  EXPECT_NE(refusal(folder("whole"), other).find("about"), std::string::npos);
  EXPECT_EQ(contents(journalPath(folder("whole"))), whole);
}

TEST(LeagueJournal, IsOfOneProcessAtATime) {
  const std::string where = folder("taken");
  {
    const auto first = LeagueJournal::open(where, smallPlan());
    ASSERT_TRUE(first.ok());
    EXPECT_EQ(refusal(where, smallPlan()), where + ": another process plays this league");
  }
  EXPECT_EQ(refusal(where, smallPlan()), "");
}

TEST(LeagueJournal, DamagedBeforeItsEndIsRefusedWithTheLine) {
  std::string text = wholeJournal();
  const auto second = text.find('\n', text.find('\n') + 1) + 1;
  text[second + 3] = '\0';
  write(journalPath(folder("damaged")), text);
  EXPECT_EQ(refusal(folder("damaged"), smallPlan()),
            journalPath(folder("damaged")) + ":3: damaged: not a match of this league");
  EXPECT_EQ(contents(journalPath(folder("damaged"))), text);
}

TEST(LeagueJournal, WithAMatchTwiceIsRefused) {
  std::string text = wholeJournal();
  text += text.substr(text.rfind('\n', text.size() - 2) + 1);
  write(journalPath(folder("twice")), text);
  EXPECT_NE(refusal(folder("twice"), smallPlan()).find(":14: damaged"), std::string::npos);
}

TEST(LeagueJournal, AChangedHeaderIsRefused) {
  std::string text = wholeJournal();
  text.replace(text.find("a test"), 6, "a tent");
  write(journalPath(folder("changed")), text);
  EXPECT_NE(refusal(folder("changed"), smallPlan()).find("damaged header"), std::string::npos);
}

TEST(LeagueJournal, SomebodyElsesFileIsRefusedAndLeftAsItIs) {
  for (const char* text : {"my notes", "my notes\n", "{\"version\":1}\n", "[]\n", "null\n"}) {
    write(journalPath(folder("notes")), text);
    EXPECT_NE(refusal(folder("notes"), smallPlan()).find("not the journal"), std::string::npos);
    EXPECT_EQ(contents(journalPath(folder("notes"))), text);
  }
}

TEST(LeagueJournal, KeepsTheTroubleOfAVoidMatchAndForgetsItOnRequest) {
  const std::string where = folder("void");
  const Play broken = [](const LeagueMatch& match) {
    MatchResult result = RandomPlay{}(match);
    if (match.red == "a") result.trouble = "no \"\xff\" program\n";
    return result;
  };
  {
    auto journal = LeagueJournal::open(where, smallPlan());
    ASSERT_TRUE(journal.ok());
    EXPECT_EQ(runLeague(*journal, broken, 1)->voids, 4U);
  }
  auto journal = LeagueJournal::open(where, smallPlan());
  ASSERT_TRUE(journal.ok()) << journal.error();
  EXPECT_EQ(runLeague(*journal, RandomPlay{}, 1)->played, 0U);
  const std::string trouble = journal->results()[0]->trouble;
  journal->forgetVoids();
  EXPECT_EQ(runLeague(*journal, RandomPlay{}, 1)->played, 4U);
  EXPECT_EQ(trouble, "no \"?\" program?");
  const auto again = readLeague(where);
  ASSERT_TRUE(again.ok()) << again.error();
  EXPECT_EQ(standingsOf(*again).voids, 0U);
}

TEST(LeagueJournal, IsReadWhileTheLeagueGoesOn) {
  const std::string where = folder("read");
  EXPECT_FALSE(readLeague(where));
  auto journal = LeagueJournal::open(where, smallPlan());
  ASSERT_TRUE(journal.ok());
  std::vector<std::size_t> counts;
  RunTalk talk;
  talk.finished = [&](std::size_t, const MatchResult&) {
    const auto league = readLeague(where);
    counts.push_back(league ? 12 - standingsOf(*league).left() : 99);
  };
  ASSERT_TRUE(runLeague(*journal, RandomPlay{}, 1, talk).ok());
  for (std::size_t i = 0; i < counts.size(); ++i) EXPECT_EQ(counts[i], i + 1);
}

// In a process of its own, of which no file may grow beyond `bytes`.
int playWithin(const std::string& where, rlim_t bytes) {
  const pid_t child = fork();
  if (child == 0) {
    signal(SIGXFSZ, SIG_IGN);
    const rlimit limit{bytes, bytes};
    setrlimit(RLIMIT_FSIZE, &limit);
    auto journal = LeagueJournal::open(where, smallPlan());
    const auto summary = runLeague(*journal, RandomPlay{}, 1);
    _exit(!summary && summary.error().find("File too large") != std::string::npos ? 0 : 1);
  }
  int status = 0;
  waitpid(child, &status, 0);
  return status;
}

TEST(LeagueJournal, WhatCannotBeWrittenWholeLeavesNothingAndEndsTheLeague) {
  const std::string whole = wholeJournal();
  const std::string where = folder("full");
  EXPECT_EQ(playWithin(where, whole.size() - 20), 0);
  EXPECT_EQ(contents(journalPath(where)), whole.substr(0, whole.rfind('\n', whole.size() - 2) + 1));
}

}  // namespace
}  // namespace kelpie::league
