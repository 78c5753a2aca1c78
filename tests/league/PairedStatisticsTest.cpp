// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>

#include "robot/core/Random.h"
#include "tools/league/PairedStatistics.h"
#include "tools/league/StudentT.h"

namespace kelpie::league {
namespace {

// Of the thesis' ten games between two vectors of constants (checklist E1).
const Differences kThesis{307, 236, -86, 88, -22, 88, 180, 187, -28, 165};

TEST(Statistics, TheThesisTenGamesGiveItsT) {
  const PairedStatistics of = statisticsOf(kThesis);
  EXPECT_DOUBLE_EQ(of.mean, 111.5);
  EXPECT_NEAR(of.spread, 126.65, 0.005);
  ASSERT_TRUE(of.t);
  EXPECT_NEAR(of.t->t, 2.7839, 0.00005);
  EXPECT_NEAR(of.t->p.oneSided, 0.0106, 0.00005);
  EXPECT_NEAR(of.t->p.twoSided, 0.0213, 0.00005);
  EXPECT_NEAR(of.student->low, 20.9, 0.05);
  EXPECT_NEAR(of.student->high, 202.1, 0.05);
  EXPECT_TRUE(of.signFlip.exact);
  EXPECT_DOUBLE_EQ(of.signFlip.p.oneSided, 14.0 / 1024.0);  // 0.0137
}

TEST(Statistics, HalfOfEveryDifferenceIsTheSameTest) {
  Differences halves = kThesis;
  for (double& d : halves) d *= 0.5;
  const PairedStatistics of = statisticsOf(halves);
  EXPECT_NEAR(of.mean, 55.75, 1e-12);
  EXPECT_NEAR(of.spread, 63.32, 0.01);
  EXPECT_NEAR(of.t->t, 2.7839, 0.00005);
  EXPECT_DOUBLE_EQ(of.signFlip.p.oneSided, 14.0 / 1024.0);
}

TEST(StudentT, TailsAreThoseOfTheTables) {
  EXPECT_NEAR(studentTail(2.262157, 9), 0.025, 1e-7);
  EXPECT_NEAR(studentTail(1.833113, 9), 0.05, 1e-7);
  EXPECT_NEAR(studentTail(12.706205, 1), 0.025, 1e-8);
  EXPECT_NEAR(studentTail(4.302653, 2), 0.025, 1e-8);
  EXPECT_NEAR(studentTail(2.042272, 30), 0.025, 1e-7);
  EXPECT_NEAR(studentTail(1.0, 1), 0.25, 1e-15);
  EXPECT_NEAR(studentTail(1.959964, 10000000), 0.025, 1e-7);
}

TEST(StudentT, TailsAreSymmetricAndEndAtZeroAndOne) {
  for (const int freedom : {1, 2, 3, 8, 9, 100}) {
    EXPECT_DOUBLE_EQ(studentTail(0.0, freedom), 0.5);
    for (const double t : {0.1, 1.0, 5.0, 100.0})
      EXPECT_NEAR(studentTail(t, freedom) + studentTail(-t, freedom), 1.0, 1e-15);
    EXPECT_EQ(studentTail(std::numeric_limits<double>::infinity(), freedom), 0.0);
  }
}

TEST(StudentT, AQuantileIsExceededJustAsOften) {
  for (const int freedom : {1, 2, 9, 50})
    for (const double tail : {0.4, 0.05, 0.025, 1e-6})
      EXPECT_NEAR(studentTail(studentQuantile(tail, freedom), freedom) / tail, 1.0, 1e-6);
}

TEST(Statistics, OfTooFewOrEqualDifferencesThereIsNoT) {
  for (const Differences& few : {Differences{}, {1.0}, {0.1, 0.1, 0.1}}) {
    EXPECT_FALSE(tTest(few));
    EXPECT_FALSE(studentInterval(few, 0.95));
  }
  const PairedStatistics none = statisticsOf({});
  EXPECT_EQ(none.signFlip.p.oneSided, 1.0);
  EXPECT_EQ(none.signFlip.p.twoSided, 1.0);
  EXPECT_EQ(none.bootstrap.low, 0.0);
}

TEST(SignFlip, CountsTheWaysThatAreAsFar) {
  const SignFlip of = signFlip({1.0, 2.0, 3.0}, {});  // sums 6, 4, 2, 0, 0, -2, -4, -6
  EXPECT_DOUBLE_EQ(of.p.oneSided, 1.0 / 8.0);
  EXPECT_DOUBLE_EQ(of.p.twoSided, 2.0 / 8.0);
  EXPECT_DOUBLE_EQ(signFlip({-1.0, 2.0, 3.0}, {}).p.oneSided, 2.0 / 8.0);
  EXPECT_DOUBLE_EQ(signFlip({-1.0, -2.0, -3.0}, {}).p.oneSided, 1.0);
  EXPECT_DOUBLE_EQ(signFlip({-1.0, -2.0, -3.0}, {}).p.twoSided, 2.0 / 8.0);
}

TEST(SignFlip, AZeroHasNoSignAndRoundingNoWeight) {
  Differences zeros{1.0, 2.0, 3.0};
  zeros.resize(60, 0.0);
  EXPECT_TRUE(signFlip(zeros, {}).exact);
  EXPECT_DOUBLE_EQ(signFlip(zeros, {}).p.oneSided, 1.0 / 8.0);
  EXPECT_DOUBLE_EQ(signFlip({0.1, 0.2, 0.3, -0.6}, {}).p.oneSided, 9.0 / 16.0);
  EXPECT_DOUBLE_EQ(signFlip({0.0, 0.0}, {}).p.twoSided, 1.0);
}

// P(sum of flipped differences >= observed), by adding one difference after the other.
double exactFlip(const std::vector<int>& differences) {
  std::map<int, double> shares{{0, 1.0}};
  int observed = 0;
  for (const int d : differences) {
    std::map<int, double> next;
    for (const auto& [sum, share] : shares)
      for (const int sign : {-1, 1}) next[sum + sign * d] += 0.5 * share;
    shares = next;
    observed += d;
  }
  double above = 0.0;
  for (const auto& [sum, share] : shares) above += sum >= observed ? share : 0.0;
  return above;
}

TEST(SignFlip, OfManyDifferencesIsDrawnCloseToTheExactOne) {
  const std::vector<int> whole{3,  -1, 2, 2,  -2, 1, 4,  -3, 1, 1,  -1, 2, 5,
                               -2, 1,  2, -4, 3,  1, -1, 2,  1, -2, 3,  -1};
  const Differences differences(whole.begin(), whole.end());
  const SignFlip drawn = signFlip(differences, {});
  EXPECT_FALSE(drawn.exact);
  EXPECT_NEAR(drawn.p.oneSided, exactFlip(whole), 0.004);
  EXPECT_NEAR(drawn.p.twoSided, 2.0 * exactFlip(whole), 0.006);
  EXPECT_EQ(drawn.p.oneSided, signFlip(differences, {}).p.oneSided);
}

TEST(SignFlip, DrawnIsNeverZero) {
  EXPECT_DOUBLE_EQ(signFlip(Differences(100, 1.0), {}).p.oneSided, 1.0 / 100001.0);
}

TEST(Bootstrap, IsSeededAndMovesWithTheDifferences) {
  const Interval one = bootstrap(kThesis, {});
  Differences moved = kThesis;
  for (double& d : moved) d = 1000.0 - 2.0 * d;
  const Interval other = bootstrap(moved, {});
  EXPECT_EQ(one.low, bootstrap(kThesis, {}).low);
  EXPECT_NEAR(other.high, 1000.0 - 2.0 * one.low, 1e-9);
  EXPECT_NEAR(other.low, 1000.0 - 2.0 * one.high, 1e-9);
  EXPECT_LT(one.low, 111.5);
  EXPECT_GT(one.high, 111.5);
}

// Of normal differences; 2000 draws have a standard error of half a percent.
TEST(Intervals, HoldTheTrueMeanAsOftenAsTheySay) {
  Random random(5);
  Resampling params;
  params.resamples = 2000;
  int student = 0;
  int boot = 0;
  const auto holds = [](const Interval& of) { return of.low <= 3.0 && 3.0 <= of.high ? 1 : 0; };
  for (int i = 0; i < 2000; ++i) {
    Differences differences(10);
    for (double& d : differences) d = random.gaussian(3.0, 2.0);
    params.seed = static_cast<std::uint64_t>(i);
    student += holds(*studentInterval(differences, 0.95));
    boot += holds(bootstrap(differences, params));
  }
  EXPECT_NEAR(student / 2000.0, 0.95, 0.015);
  EXPECT_NEAR(boot / 2000.0, 0.95, 0.02);
}

}  // namespace
}  // namespace kelpie::league
