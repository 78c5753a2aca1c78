// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>

#include "tools/learn/Search.h"

namespace kelpie::learn {
namespace {

const SearchSpace kSpace{{"x", "y"}, {-5.0, -5.0}, {5.0, 5.0}, {4.0, 4.0}};

double hill(const std::vector<double>& p) {
  return -(p[0] - 1.0) * (p[0] - 1.0) - (p[1] + 2.0) * (p[1] + 2.0);
}

void nothing(int, double) {}

class JournalFile {
 public:
  JournalFile() : path_(std::filesystem::temp_directory_path() / "kelpie_search_test.journal") {
    std::filesystem::remove(path_);
  }
  ~JournalFile() { std::filesystem::remove(path_); }
  std::string path() const { return path_.string(); }

 private:
  std::filesystem::path path_;
};

SearchPlan planOf(int trials, const std::string& journal = "") {
  SearchPlan plan;
  plan.trials = trials;
  plan.seed = 3;
  plan.journal = journal;
  return plan;
}

TEST(Search, FindsTheTopOfAHill) {
  const auto found = search(kSpace, planOf(300), hill, nothing);
  ASSERT_TRUE(found.ok());
  EXPECT_NEAR(found->best[0], 1.0, 0.05);
  EXPECT_NEAR(found->best[1], -2.0, 0.05);
}

TEST(Search, GoesOnWhereItWasBrokenOff) {
  const JournalFile journal;
  ASSERT_TRUE(search(kSpace, planOf(60, journal.path()), hill, nothing).ok());
  int asked = 0;
  const auto again = search(
      kSpace, planOf(100, journal.path()),
      [&](const std::vector<double>& p) {
        ++asked;
        return hill(p);
      },
      nothing);
  const auto whole = search(kSpace, planOf(100), hill, nothing);
  ASSERT_TRUE(again.ok() && whole.ok());
  EXPECT_EQ(again->best, whole->best);
  EXPECT_GE(again->replayed, 60);
  EXPECT_LE(asked, 45);
}

TEST(Search, ALineThatWasCutOffIsTriedAgain) {
  const JournalFile journal;
  ASSERT_TRUE(search(kSpace, planOf(40, journal.path()), hill, nothing).ok());
  std::ofstream(journal.path(), std::ios::app) << "0x1p+0 0x1.8";
  const auto again = search(kSpace, planOf(60, journal.path()), hill, nothing);
  ASSERT_TRUE(again.ok());
  EXPECT_EQ(again->best, search(kSpace, planOf(60), hill, nothing)->best);
}

TEST(Search, ANumberThatWasCutOffIsTriedAgain) {
  const JournalFile journal;
  ASSERT_TRUE(search(kSpace, planOf(40, journal.path()), hill, nothing).ok());
  std::filesystem::resize_file(journal.path(), std::filesystem::file_size(journal.path()) - 6);
  const auto again = search(kSpace, planOf(40, journal.path()), hill, nothing);
  ASSERT_TRUE(again.ok());
  EXPECT_EQ(again->replayed, 39);
}

TEST(Search, BrokenOffTwiceTriesNothingTwice) {
  const JournalFile journal;
  for (const int trials : {20, 40})
    ASSERT_TRUE(search(kSpace, planOf(trials, journal.path()), hill, nothing).ok());
  const auto again = search(kSpace, planOf(60, journal.path()), hill, nothing);
  ASSERT_TRUE(again.ok());
  EXPECT_EQ(again->replayed, 40);
  EXPECT_EQ(again->best, search(kSpace, planOf(60), hill, nothing)->best);
}

TEST(Search, AJournalOfOtherTrialsIsRefused) {
  const JournalFile journal;
  ASSERT_TRUE(search(kSpace, planOf(40, journal.path()), hill, nothing).ok());
  SearchPlan plan = planOf(40, journal.path());
  plan.trial = "models 2";
  EXPECT_FALSE(search(kSpace, plan, hill, nothing).ok());
}

TEST(Search, AJournalThatIsNoFileIsRefused) {
  EXPECT_FALSE(search(kSpace, planOf(5, "/dev/null"), hill, nothing).ok());
  EXPECT_FALSE(search(kSpace, planOf(5, "/tmp"), hill, nothing).ok());
  EXPECT_TRUE(std::filesystem::is_character_file("/dev/null"));
}

TEST(Search, AJournalOfAnotherSearchIsRefused) {
  const JournalFile journal;
  ASSERT_TRUE(search(kSpace, planOf(30, journal.path()), hill, nothing).ok());
  SearchPlan other = planOf(30, journal.path());
  other.seed = 4;
  const auto refused = search(kSpace, other, hill, nothing);
  ASSERT_FALSE(refused.ok());
  EXPECT_NE(refused.error().find("another search"), std::string::npos);
}

// A narrow valley: what is good in one number depends on the other.
double valley(const std::vector<double>& p) {
  const double along = p[0] + p[1] - 1.0;
  const double across = p[0] - p[1];
  return -along * along - 100.0 * across * across;
}

TEST(Search, FollowsANarrowValley) {
  const auto found = search(kSpace, planOf(400), valley, nothing);
  ASSERT_TRUE(found.ok()) << found.error();
  EXPECT_NEAR(found->best[0], 0.5, 0.01);
  EXPECT_NEAR(found->best[1], 0.5, 0.01);
}

TEST(Search, StaysWithinItsBounds) {
  const auto inside = [](const std::vector<double>& p) {
    for (const double number : p) EXPECT_LE(std::fabs(number), 5.0);
    return p[0] + p[1];
  };
  const auto found = search(kSpace, planOf(200), inside, nothing);
  ASSERT_TRUE(found.ok());
  EXPECT_GT(found->gain, 9.9);
}

}  // namespace
}  // namespace kelpie::learn
