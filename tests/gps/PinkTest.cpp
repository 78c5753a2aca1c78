// SPDX-License-Identifier: Apache-2.0
// Pink patches on the outer wall: where they are mapped, what is not, and what one tells of the
// pose.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "gps/GpsParams.h"
#include "gps/GpsState.h"
#include "gps/Refusal.h"
#include "gps/pinks/PinkMap.h"
#include "gps/pinks/PinkUpdate.h"
#include "robot/body/Camera.h"
#include "tools/sim/world/LocalisingRobot.h"

namespace kelpie::gps {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

// Seen from a camera above the robot frame's origin.
PinkBearing bearingTo(double headingDeg, double elevationDeg = 0.0) {
  PinkBearing bearing;
  bearing.eyeHeight = 20.0;
  bearing.heading = Angle::deg(headingDeg);
  bearing.elevation = Angle::deg(elevationDeg);
  bearing.variance = maths::square(Angle::deg(0.7).rad());
  bearing.area = 100.0;
  return bearing;
}

// A robot in the middle of the field, sure of its place, facing up-field.
struct Mapper {
  Mapper() {
    params.field = *body::fieldDescription("2006");
    PoseMode mode;
    mode.weight = 1.0;
    mode.pose = {{180.0, 270.0}, Angle::deg(90.0)};
    mode.covariance = {4, 0, 0, 0, 4, 0, 0, 0, 1e-4};
    state.pose.modes.push_back(mode);
    state.pose.lost = false;
  }
  void see(const PinkBearing& bearing) {
    PinkBearings bearings;
    bearings.push_back(bearing);
    const auto landmarks = body::landmarksFor(params.field, TeamColour::red);
    mapPatches({bearings, state.pose, landmarks}, params.pinks, state.pinks.map, state.counts);
  }
  bool update(const PinkBearing& bearing) {
    const PaintedField field{params.field, state.lines.features};
    return updateByPink(bearing,
                        {field, params.pinks, params.modes, params.gates, params.lines.update},
                        state.pinks, state.pose.modes);
  }
  int refused(Refusal reason) const {
    return state.counts.refused[static_cast<std::size_t>(reason)];
  }
  GpsParams params;
  GpsState state;
};

TEST(PinkWall, RayMeetsTheSideAhead) {
  const auto place = meetWall({{180, 270}, {0, 1}}, PinkMapParams{}.wall);
  ASSERT_TRUE(place);
  EXPECT_NEAR(place->x, 180.0, 1e-9);
  EXPECT_NEAR(place->y, 585.0, 1e-9);
}

TEST(PinkWall, WallNeedNotBeARectangle) {
  const std::array<double, 8> wall{0, 0, 400, 0, 300, 600, 0, 500};
  const double root = std::sqrt(0.5);
  // y = x + 100 meets the upper side y = 500 + x / 3 at x = 600, beyond it; the right one, which is
  // x = 400 - y / 6, at x = 400 - (x + 100) / 6: x = 328.571.
  const auto place = meetWall({{100, 200}, {root, root}}, wall);
  ASSERT_TRUE(place);
  EXPECT_NEAR(place->x, 328.5714, 1e-3);
  EXPECT_NEAR(place->y, 428.5714, 1e-3);
}

TEST(PinkWall, FromOutsideTheNearerSideCountsAndAwayFromItNone) {
  const auto place = meetWall({{-100, 200}, {1, 0}}, PinkMapParams{}.wall);
  ASSERT_TRUE(place);
  EXPECT_NEAR(place->x, -35.0, 1e-9);
  EXPECT_FALSE(meetWall({{-100, 200}, {-1, 0}}, PinkMapParams{}.wall));
}

TEST(PinkMap, HeightAtTheWallKeepsAndDropsAtItsLimits) {
  PinkMapParams params;
  params.minHeight = 0.0;
  params.maxHeight = 30.0;
  EXPECT_TRUE(mayHangOnWall(20, Angle::deg(1.9), 300, params));   // 20 + 10.0 cm
  EXPECT_FALSE(mayHangOnWall(20, Angle::deg(2.0), 300, params));  // 20 + 10.5
  EXPECT_TRUE(mayHangOnWall(20, Angle::deg(5.0), 100, params));   // 20 + 8.7: nearer, so higher
  EXPECT_TRUE(mayHangOnWall(20, Angle::deg(-3.8), 300, params));  // 20 - 19.9
  EXPECT_FALSE(mayHangOnWall(20, Angle::deg(-3.9), 300, params));
}

TEST(PinkMap, RayPastABeaconIsRefusedOneBehindIsNot) {
  const auto landmarks = body::landmarksFor(*body::fieldDescription("2006"), TeamColour::red);
  // The beacon at (-15, 135), seen from (180, 135).
  EXPECT_FALSE(clearOfBeacons({{180, 135}, {-1, 0}}, landmarks, 25.0));
  EXPECT_TRUE(clearOfBeacons({{180, 161}, {-1, 0}}, landmarks, 25.0));
  EXPECT_FALSE(clearOfBeacons({{180, 159}, {-1, 0}}, landmarks, 25.0));
  EXPECT_TRUE(clearOfBeacons({{0, 135}, {0.0, 1.0}}, landmarks, 10.0));
  EXPECT_TRUE(clearOfBeacons({{0, 140}, {0.6, -0.8}}, landmarks, 25.0));
}

TEST(PinkMap, SightingsAreMappedByTheirReasonOrCounted) {
  Mapper mapper;
  mapper.see(bearingTo(0));
  ASSERT_EQ(mapper.state.pinks.map.size(), 1U);
  EXPECT_NEAR(mapper.state.pinks.map[0].position.y, 585.0, 1e-6);
  mapper.see(bearingTo(0, 40));
  EXPECT_EQ(mapper.refused(Refusal::pinkElevation), 1);
  const double beacon = std::atan2(405.0 - 270.0, 375.0 - 180.0) * 180 / maths::kPi - 90.0;
  mapper.see(bearingTo(beacon));
  EXPECT_EQ(mapper.refused(Refusal::pinkNearBeacon), 1);
  mapper.state.pose.modes[0].covariance[0] = 400.0;
  mapper.see(bearingTo(0));
  EXPECT_EQ(mapper.refused(Refusal::pinkPoseUnsure), 1);
  EXPECT_EQ(mapper.state.pinks.map[0].weight, 1.0);
}

TEST(PinkMap, NearSightingsMergeByWeightFarOnesDoNot) {
  PinkLandmarks map;
  addToMap({0, 0}, 25, map);
  addToMap({12, 0}, 25, map);
  addToMap({0, 24}, 25, map);
  ASSERT_EQ(map.size(), 1U);
  EXPECT_EQ(map[0].weight, 3.0);
  EXPECT_NEAR(map[0].position.x, 4.0, 1e-9);
  EXPECT_NEAR(map[0].position.y, 8.0, 1e-9);
  addToMap({4, 33.5}, 25, map);
  EXPECT_EQ(map.size(), 2U);
}

TEST(PinkMap, FullMapRefuses) {
  PinkLandmarks map;
  for (std::size_t i = 0; i < kMaxPinks; ++i)
    EXPECT_TRUE(addToMap({100.0 * static_cast<double>(i), 0}, 25, map));
  EXPECT_FALSE(addToMap({-200, 0}, 25, map));
  EXPECT_TRUE(addToMap({5, 0}, 25, map));
}

TEST(PinkMap, EveryFourSecondsTakeOneAndLeaveNoNoise) {
  Mapper mapper;
  PinkState& pinks = mapper.state.pinks;
  pinks.map.push_back({{0, 0}, 1.0});
  pinks.map.push_back({{100, 0}, 3.0});
  for (int frame = 0; frame < 3 * 30; ++frame) forget(1.0 / 30, mapper.params.pinks, pinks);
  EXPECT_EQ(pinks.map.size(), 2U);
  for (int frame = 0; frame < 2 * 30; ++frame) forget(1.0 / 30, mapper.params.pinks, pinks);
  ASSERT_EQ(pinks.map.size(), 1U);
  EXPECT_EQ(pinks.map[0].weight, 2.0);
}

// Two modes, two mapped patches: four corrected and two copies, with the weights of equation 2.9.
TEST(PinkUpdate, MakesMTimesNPlusOneModesWithTheirWeights) {
  Mapper mapper;
  GpsState& state = mapper.state;
  GpsParams& params = mapper.params;
  state.pose.modes[0].weight = 0.75;
  state.pose.modes.push_back(state.pose.modes[0]);
  state.pose.modes[1].weight = 0.25;
  state.pose.modes[1].pose.position = {180.0, 200.0};
  state.pinks.map.push_back({{180.0, 585.0}, 10.0});
  state.pinks.map.push_back({{395.0, 270.0}, 10.0});
  params.pinks.mapSd = 0.0;
  ASSERT_TRUE(mapper.update(bearingTo(0)));
  ASSERT_EQ(state.pose.modes.size(), 6U);
  // Mode 0 and the patch ahead: the innovation is 0, so w S / N = 0.75 / 2.
  EXPECT_NEAR(state.pose.modes[1].weight, 0.375, 1e-9);
  // Mode 0 and the patch at its right, 215 cm away: innovation 90 deg; the gradient of the bearing
  // is (d.y, -d.x) / r2 = (0, -1 / 215) and -1, so e = 4 / 215^2 + 1e-4 + sd^2.
  const double sd2 = maths::square(1.5 * maths::kPi / 180);
  const double e = 4.0 / (215.0 * 215.0) + 1e-4 + sd2;
  const double s = std::exp(-0.5 * maths::square(maths::kPi / 2) / e);
  EXPECT_NEAR(state.pose.modes[2].weight, 0.375 * s, 1e-12);
  EXPECT_NEAR(state.pose.modes[0].weight, 0.75 * params.modes.outlierWeight, 1e-12);
  EXPECT_NEAR(state.pose.modes[3].weight, 0.25 * params.modes.outlierWeight, 1e-12);
  // Its heading: h' = h - gain * innovation with innovation 0; the variance shrinks to
  // P - P H' H P / e with H = (0, 0, -1) and (1 / 315) across: only x and heading.
  const double ahead = 4.0 / (315.0 * 315.0) + 1e-4 + sd2;
  EXPECT_NEAR(state.pose.modes[1].covariance[8], 1e-4 - 1e-8 / ahead, 1e-9);
  EXPECT_NEAR(state.pose.modes[1].covariance[0], 4.0 - maths::square(4.0 / 315.0) / ahead, 1e-6);
}

TEST(PinkUpdate, KeepsTheHeaviestWhenThereIsNoRoom) {
  Mapper mapper;
  GpsState& state = mapper.state;
  for (int i = 1; i < 8; ++i) state.pose.modes.push_back(state.pose.modes[0]);
  for (std::size_t i = 0; i < 8; ++i) state.pose.modes[i].weight = i == 7 ? 0.93 : 0.01;
  for (int i = 0; i < 16; ++i) state.pinks.map.push_back({{25.0 * i + 5.0, 585.0}, 10.0});
  ASSERT_TRUE(mapper.update(bearingTo(0)));
  EXPECT_EQ(state.pose.modes.size(), kWorkModes);
  double heaviest = 0.0;
  for (const PoseMode& mode : state.pose.modes) heaviest = std::max(heaviest, mode.weight);
  EXPECT_NEAR(heaviest, 0.93 / 16, 1e-9);
}

TEST(PinkUpdate, PatchTooHighForAMappedOneIsNotTakenForIt) {
  Mapper mapper;
  mapper.state.pinks.map.push_back({{180.0, 585.0}, 10.0});
  ASSERT_TRUE(mapper.update(bearingTo(0, 30)));
  EXPECT_EQ(mapper.state.pose.modes.size(), 1U);  // the copy alone
}

TEST(PinkUpdate, WithoutAMapNothingChanges) {
  Mapper mapper;
  EXPECT_FALSE(mapper.update(bearingTo(0)));
  mapper.state.pinks.map.push_back({{180.0, 585.0}, 1.0});  // too little weight to be believed
  EXPECT_FALSE(mapper.update(bearingTo(0)));
  EXPECT_EQ(mapper.state.pose.modes.size(), 1U);
}

PinkPercept perceptAt(double distance, double headingDeg, double size) {
  PinkPercept percept;
  percept.distance = distance;
  percept.heading = Angle::deg(headingDeg);
  percept.headingVariance = 1e-4;
  percept.box = {0.0, 0.0, size, size};
  return percept;
}

TEST(PinkBearing, IsTheDirectionFromTheCamera) {
  CameraPose camera;
  camera.position = {-10.0, 0.0, 20.0};
  const auto bearing = bearingOf(perceptAt(250.0, 0.0, 10.0), camera);
  ASSERT_TRUE(bearing);
  EXPECT_NEAR(bearing->heading.deg(), -std::atan2(10.0, 250.0) * 180 / maths::kPi, 1e-9);
  EXPECT_NEAR(headingAt(*bearing, 250.0).deg(), 0.0, 1e-9);
  // Through (0, 250) from (-10, 0): at y = 125 it is 5 cm to the left.
  EXPECT_NEAR(headingAt(*bearing, std::hypot(5.0, 125.0)).deg(),
              std::atan2(5.0, 125.0) * 180 / maths::kPi, 1e-9);
}

TEST(PinkBearing, LargestComeFirstAndBrokenOnesAreCounted) {
  Mapper mapper;
  FrameInput input;
  Percepts percepts;
  percepts.pinkPatches.push_back(perceptAt(250.0, 10.0, 5.0));
  percepts.pinkPatches.push_back(perceptAt(250.0, kNan, 30.0));
  percepts.pinkPatches.push_back(perceptAt(250.0, 20.0, 9.0));
  const PinkBearings bearings =
      bearingsOf({input, percepts, body::step(input, {}).camera}, mapper.state.counts);
  ASSERT_EQ(bearings.size(), 2U);
  EXPECT_NEAR(bearings[0].area, 81.0, 1e-9);
  EXPECT_EQ(mapper.refused(Refusal::pinkNotFinite), 1);
}

TEST(PinkMap, ARayAlongTheWallThatPassesAKnownPatchIsASightingOfIt) {
  const PinkMapParams params;
  PinkLandmarks map;
  map.push_back({{0.0, -45.0}, 10.0});
  const Point2<Field> from{200.0, 15.0};
  const auto rayTo = [&](Point2<Field> to) {
    const Point2<Field> way = to - from;
    const double length = maths::hypot(way.x, way.y);
    return Ray{from, {way.x / length, way.y / length}};
  };
  EXPECT_EQ(glancedAt(rayTo({-28, -45}), {-28, -45}, params, map), &map[0]);
  EXPECT_EQ(glancedAt(rayTo({-100, -45}), {-100, -45}, params, map), nullptr);  // too far beyond
  const Ray across{{-28, 200}, {0.0, -1.0}};  // passes 28 cm beside it
  EXPECT_EQ(glancedAt(across, {-28, -45}, params, map), nullptr);
  map[0].weight = params.minWeight - 1.0;
  EXPECT_EQ(glancedAt(rayTo({-28, -45}), {-28, -45}, params, map), nullptr);
}

}  // namespace
}  // namespace kelpie::gps
