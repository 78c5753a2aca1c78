// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "tools/experiments/harness/Statistics.h"

namespace kelpie::experiments {
namespace {

const Values kSome{3.0, -1.0, 4.0, 2.0};

TEST(Statistics, AreThoseOfTheTextbook) {
  EXPECT_EQ(sum(kSome), 8.0);
  EXPECT_EQ(mean(kSome), 2.0);
  EXPECT_DOUBLE_EQ(rms(kSome), std::sqrt(30.0 / 4.0));
  EXPECT_DOUBLE_EQ(standardDeviation(kSome), std::sqrt(3.5));
  EXPECT_EQ(percentile(kSome, 0.5), 2.5);
  EXPECT_EQ(shareAbove(kSome, 2.0), 0.5);
  EXPECT_EQ(shareUpTo(kSome, 2.0), 0.5);
}

TEST(Statistics, OfNoValuesAreZero) {
  for (const auto statistic : {sum, mean, rms, standardDeviation}) EXPECT_EQ(statistic({}), 0.0);
  EXPECT_EQ(shareAbove({}, 0.0), 0.0);
  EXPECT_EQ(percentile({}, 0.5), 0.0);
  EXPECT_EQ(Share{}.value(), 0.0);
  EXPECT_EQ(ratio(1.0, 0.0), 0.0);
}

TEST(Statistics, AShareCountsHitsAmongAll) {
  Share share;
  for (const bool hit : {true, false, false, true, true}) share.count(hit);
  Share both = share;
  both.add(share);
  EXPECT_EQ(share.value(), 0.6);
  EXPECT_EQ(both.all, 10);
  EXPECT_EQ(both.value(), 0.6);
}

}  // namespace
}  // namespace kelpie::experiments
