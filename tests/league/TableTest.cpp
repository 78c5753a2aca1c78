// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include "tests/league/RandomPlay.h"
#include "tools/league/Table.h"

namespace kelpie::league {
namespace {

Standings someStandings() {
  LeaguePlan plan = smallPlan();
  plan.sides = {"first <b>", "second & \"third\"", "c"};
  plan.matchesAPair = 20;
  LeagueRecord league = playedLeague(plan, RandomPlay{});
  league.results[3]->trouble = "agent <2> died";
  league.results[7].reset();
  return standingsOf(league);
}

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST(Table, EveryRowHasACellForEveryHead) {
  const Standings standings = someStandings();
  for (const Table& table : {sideTable(standings), pairTable(standings)}) {
    EXPECT_EQ(table.rows.size(), 3U);
    for (const TableRow& row : table.rows) EXPECT_EQ(row.cells.size(), table.heads.size());
  }
}

TEST(Table, TheTextTellsWhatWasAskedPlayedAndLost) {
  const std::string text = textOf(someStandings());
  EXPECT_TRUE(has(text, "3 sides, 20 matches a pair of 10 min, seeds 7 to 16"));
  EXPECT_TRUE(has(text, "56 of 60 matches counted, 1 to be played, 1 void, 2 without"));
  EXPECT_TRUE(has(text, "void: match 3, red c, blue first <b>, seed 7: agent <2> died"));
  EXPECT_TRUE(has(text, "95 % interval"));
}

TEST(Table, OfALeagueNotYetBegunHasDashes) {
  LeagueRecord league{smallPlan(), Results(12)};
  const Standings standings = standingsOf(league);
  EXPECT_EQ(sideTable(standings).rows[0].cells.back(), "-");
  EXPECT_FALSE(sideTable(standings).rows[0].interval);
  EXPECT_TRUE(writeTables(standings, testing::TempDir()).ok());
}

TEST(Table, ThePageStandsAloneAndIsEscaped) {
  const std::string page = pageOf(someStandings());
  EXPECT_TRUE(has(page, "first &lt;b&gt;"));
  EXPECT_TRUE(has(page, "second &amp; &quot;third&quot;"));
  EXPECT_TRUE(has(page, "agent &lt;2&gt; died"));
  EXPECT_FALSE(has(page, "<b>"));
  for (const char* banned : {"<script", "http", "src=", "href", "@import", "url("})
    EXPECT_FALSE(has(page, banned)) << banned;
}

TEST(Table, IsWrittenAsTextPageAndPictureWithoutLeftovers) {
  const std::string folder = testing::TempDir() + "/tables";
  std::filesystem::create_directories(folder);
  ASSERT_TRUE(writeTables(someStandings(), folder).ok());
  std::ifstream png(folder + "/table.png", std::ios::binary);
  std::string magic(8, '\0');
  png.read(magic.data(), 8);
  EXPECT_EQ(magic, "\x89PNG\r\n\x1a\n");
  const std::filesystem::directory_iterator files(folder);
  EXPECT_EQ(std::distance(begin(files), end(files)), 3);
  EXPECT_FALSE(writeTables(someStandings(), folder + "/absent"));
}

}  // namespace
}  // namespace kelpie::league
