// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "vision/Refusal.h"
#include "vision/Together.h"

namespace kelpie::vision {
namespace {

LandmarkPercept seen(LandmarkKind kind, double width) {
  LandmarkPercept percept;
  percept.kind = kind;
  percept.box = {50.0, 60.0, 50.0 + width, 80.0};
  return percept;
}

TEST(Together, OfTwoGoalsTheSmallerIsDroppedAndCounted) {
  Percepts percepts;
  percepts.landmarks.push_back(seen(LandmarkKind::goalBlue, 12.0));
  percepts.landmarks.push_back(seen(LandmarkKind::beaconPinkOnBlue, 8.0));
  percepts.landmarks.push_back(seen(LandmarkKind::goalYellow, 60.0));
  keepOneGoal(percepts);
  ASSERT_EQ(percepts.landmarks.size(), 2U);
  EXPECT_EQ(percepts.landmarks[0].kind, LandmarkKind::beaconPinkOnBlue);
  EXPECT_EQ(percepts.landmarks[1].kind, LandmarkKind::goalYellow);
  EXPECT_EQ(percepts.counts.refused[static_cast<std::size_t>(Refusal::goalOpposite)], 1);
}

TEST(Together, OneGoalAndBeaconsStay) {
  Percepts percepts;
  percepts.landmarks.push_back(seen(LandmarkKind::goalBlue, 12.0));
  percepts.landmarks.push_back(seen(LandmarkKind::beaconPinkOnBlue, 8.0));
  keepOneGoal(percepts);
  EXPECT_EQ(percepts.landmarks.size(), 2U);
}

}  // namespace
}  // namespace kelpie::vision
