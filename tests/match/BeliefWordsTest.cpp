// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "tools/match/BeliefWords.h"

namespace kelpie::match {
namespace {

TEST(BeliefWords, ABeaconIsNamedFromTheTopDownWithItsWay) {
  EXPECT_EQ(sentenceOf(MovedLandmark{LandmarkKind::beaconPinkOnYellow, {-8.4, 11.2}}),
            "The pink/yellow beacon seems to stand 14 cm off its place.");
}

TEST(BeliefWords, AGoalIsNoBeacon) {
  EXPECT_EQ(sentenceOf(MovedLandmark{LandmarkKind::goalBlue, {0.0, 8.26}}),
            "The blue goal seems to stand 8.3 cm off its place.");
}

}  // namespace
}  // namespace kelpie::match
