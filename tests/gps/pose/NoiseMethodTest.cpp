// SPDX-License-Identifier: Apache-2.0
// What becomes of a sighting that no mode predicted: methods 2 and 3 of thesis 2004 section 2.2.3,
// and beginning anew. Method 1 is a baseline of the experiments.
#include <gtest/gtest.h>

#include "gps/pose/Modes.h"
#include "gps/pose/Outliers.h"
#include "gps/pose/PoseUpdate.h"
#include "tests/gps/FalseSighting.h"

namespace kelpie::gps {
namespace {

sim::LocalisingRobot localised(double wideWeight) {
  sim::LocalisingRobot robot({180, 250, 1.5});
  robot.params.modes.wideWeight = wideWeight;
  robot.believe({{180, 250}, Angle::rad(1.5)}, 5.0, Angle::deg(3));
  robot.step();
  return robot;
}

TEST(NoiseMethod, SplittingKeepsAnUncorrectedCopyInFront) {
  for (const double wideWeight : {0.0, 1e-12}) {
    sim::LocalisingRobot robot = localised(wideWeight);
    seeFalsely(robot);
    EXPECT_GE(robot.state.pose.modes.size(), 2U);
    EXPECT_LT(robot.error(robot.step()), 0.5);
  }
}

TEST(NoiseMethod, OnlyTheThirdHasAWideMode) {
  const auto widest = [](double wideWeight) {
    sim::LocalisingRobot robot = localised(wideWeight);
    seeFalsely(robot);
    double max = 0.0;
    for (const PoseMode& mode : robot.state.pose.modes) max = std::max(max, mode.covariance[0]);
    return max;
  };
  EXPECT_LT(widest(0.0), 400.0);
  EXPECT_GT(widest(1e-12), 1000.0);
}

TEST(NoiseMethod, ManyFalseSightingsInARowBeginAnewUnlessForbidden) {
  const auto lostWithin = [](std::uint32_t maxUnexplained) {
    sim::LocalisingRobot robot = localised(0.0);
    robot.params.modes.maxUnexplained = maxUnexplained;
    bool lost = false;
    for (int i = 0; i < 15; ++i) {
      seeFalsely(robot);
      lost = lost || robot.state.pose.lost;
    }
    return lost;
  };
  EXPECT_TRUE(lostWithin(5));
  EXPECT_FALSE(lostWithin(0));
}

// A goal that is half hidden looks shifted in every frame: beside another landmark that fits, its
// second sighting says hardly more than its first; without one the robot may have been carried.
TEST(NoiseMethod, ALandmarkThatWasFalseMayWellBeFalseAgainWhereAnotherFits) {
  const ModeParams params;
  const auto kind = LandmarkKind::goalBlue;
  SightingRecords sightings{};
  EXPECT_EQ(outlierWeightOf(kind, params, sightings), params.outlierWeight);
  note({1e-9, 1e-2}, sightings[0]);
  EXPECT_NEAR(outlierWeightOf(kind, params, sightings), params.outlierWeight, 1e-6);
  note({1.0, 1e-2}, sightings[2]);
  EXPECT_GT(outlierWeightOf(kind, params, sightings), 0.2);
  EXPECT_NEAR(outlierWeightOf(LandmarkKind::goalYellow, params, sightings), params.outlierWeight,
              1e-6);
  fade(2.0, params, sightings);
  EXPECT_NEAR(outlierWeightOf(kind, params, sightings), params.outlierWeight, 1e-2);
}

// Two poses that a beacon fits equally, and a goal that is half hidden and so fits the other one.
TEST(NoiseMethod, RepeatedFalseSightingsRaiseAPoseElsewhereLessWhereAnotherLandmarkFits) {
  const auto weightElsewhere = [](double repeatedOutlierWeight) {
    const body::FieldDescription field;
    ModeParams params;
    params.wideWeight = 0.0;
    params.repeatedOutlierWeight = repeatedOutlierWeight;
    const Pose2 here{{180, 250}, Angle::deg(90)}, elsewhere{{280, 350}, Angle::deg(120)};
    GpsCounts counts;
    PoseState state;
    state.lost = false;
    PoseMode mode;
    mode.covariance = {9, 0, 0, 0, 9, 0, 0, 0, 0.001};
    for (const Pose2& pose : {here, elsewhere}) {
      mode.pose = pose;
      mode.weight = state.modes.empty() ? 1.0 : 1e-12;
      state.modes.push_back(mode);
    }
    const Expectation seen = expected(elsewhere, {180, 540});
    const Measurement hidden{{180, 540}, true, true, seen.distance, seen.heading, 25.0, 1e-3};
    Measurement beacon{{-15, 405}, false, true, 200.0, Angle::deg(60), 25.0, 1e3};
    beacon.kind = LandmarkKind::beaconPinkOnBlue;
    for (int i = 0; i < 5; ++i) {
      for (const Measurement& m : {beacon, hidden}) {
        updateAll(m, field, params, state, counts);
        mergeAndPrune(field, params, state, counts);
      }
    }
    double weight = 0.0;
    for (const PoseMode& m : state.modes)
      if (distance(m.pose.position, here.position) > 50.0) weight += m.weight;
    return weight;
  };
  const ModeParams params;
  EXPECT_GT(weightElsewhere(params.outlierWeight), 1e-3);
  EXPECT_LT(weightElsewhere(params.repeatedOutlierWeight), 1e-6);
}

}  // namespace
}  // namespace kelpie::gps
