// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>

#include "tests/vision/PaintedRobot.h"
#include "vision/Refusal.h"
#include "vision/pink/PinkFinder.h"

namespace kelpie::vision {
namespace {

int refused(const Seen& seen, Refusal reason) {
  return seen.percepts.counts.refused[static_cast<std::size_t>(reason)];
}

Painting sheetAt(double y, double low = 0.0) {
  Painting p;
  p.noise = 3.0;
  p.carpetEnd = 400;
  addWall(p, 15, y, {-6, 6, low, low + 20}, kPinkPaint);
  return p;
}

TEST(Pink, SheetOnTheCarpetIsWhereItStands) {
  for (const double y : {80.0, 140.0, 200.0}) {
    const Seen seen = look(sheetAt(y), cameraAt(17, 0, -8));
    ASSERT_EQ(seen.percepts.pinkPatches.size(), 1U) << y;
    const PinkPercept& pink = seen.percepts.pinkPatches[0];
    EXPECT_NEAR(pink.distance, std::hypot(15, y), 2.0 + 0.05 * y);
    EXPECT_NEAR(pink.heading.deg(), -std::atan2(15, y) * 57.3, 1.0);
    EXPECT_GT(pink.distanceVariance, 1.0);
  }
}

TEST(Pink, KnownSizeTellsTheDistanceOfASheetOnTheWall) {
  VisionParams params;
  params.pink.onField = false;
  params.pink.knownHeight = 20;
  Painting p = sheetAt(250, 15);
  p.carpetEnd = 200;
  const Seen seen = look(p, cameraAt(17, 0, 0), params);
  ASSERT_EQ(seen.percepts.pinkPatches.size(), 1U);
  EXPECT_NEAR(seen.percepts.pinkPatches[0].distance, 250, 20);
  EXPECT_LT(seen.percepts.pinkPatches[0].distanceVariance, 400);
}

TEST(Pink, WithoutSizeOrGroundOnlyTheHeadingMeansSomething) {
  VisionParams params;
  params.pink.onField = false;
  const Seen seen = look(sheetAt(250, 15), cameraAt(17, 0, 0), params);
  ASSERT_EQ(seen.percepts.pinkPatches.size(), 1U);
  EXPECT_GT(seen.percepts.pinkPatches[0].distanceVariance, 1e5);
  // The heading of a place 250 cm away, although the camera is beside the robot frame's origin.
  EXPECT_NEAR(seen.percepts.pinkPatches[0].heading.deg(), -std::atan2(15, 250) * 57.3, 1.0);
}

TEST(Pink, OfABeaconIsNone) {
  Painting p;
  p.carpetEnd = 190;
  p.beacons.push_back({{0, 180}, kYellowPaint, kPinkPaint});
  const Seen seen = look(p, cameraAt(17, 0, 0));
  EXPECT_TRUE(seen.percepts.pinkPatches.empty());
  EXPECT_EQ(refused(seen, Refusal::pinkIsBeacon), 1);
}

TEST(Pink, BeyondTheCarpetIsNone) {
  Painting p = sheetAt(200);
  p.carpetEnd = 160;
  const Seen seen = look(p, cameraAt(17, 0, -8));
  EXPECT_TRUE(seen.percepts.pinkPatches.empty());
  EXPECT_GE(refused(seen, Refusal::pinkOffGround) + refused(seen, Refusal::pinkAboveFieldEdge), 1);
}

TEST(Pink, InTheAirIsNone) {
  const Seen seen = look(sheetAt(120, 30), cameraAt(17, 0, 0));
  EXPECT_TRUE(seen.percepts.pinkPatches.empty());
  EXPECT_EQ(refused(seen, Refusal::pinkOffGround), 1);
}

TEST(Pink, IsNotLookedForWhenNobodyWantsIt) {
  VisionParams params;
  params.pink.wanted = false;
  EXPECT_TRUE(look(sheetAt(120), cameraAt(17, 0, -8), params).percepts.pinkPatches.empty());
}

PinkPatch goodPatch() {
  PinkPatch patch;
  patch.samples = 30;
  patch.box = {90, 50, 110, 70};
  patch.extent = {5, 5, 6, 6};
  patch.density = 0.9;
  patch.foot = {FootEnd::carpet, {100, 70}, 150};
  patch.carpetBehind = 6;
  return patch;
}

TEST(PinkChecks, SizeAndDensityDecideAtTheirLimits) {
  PinkPatch patch = goodPatch();
  EXPECT_TRUE(pinkIsLarge(patch, {}));
  EXPECT_TRUE(pinkIsDense(patch, {}));
  patch.samples = 7;
  EXPECT_FALSE(pinkIsLarge(patch, {}));
  patch.density = 0.6;
  EXPECT_FALSE(pinkIsDense(patch, {}));
  patch = goodPatch();
  patch.extent.left = patch.extent.right = 2;
  EXPECT_FALSE(pinkIsDense(patch, {}));
}

TEST(PinkChecks, ABeaconsBoxTakesWhatTouchesItAGoalsDoesNot) {
  Landmarks landmarks;
  landmarks.push_back({});
  landmarks[0].box = {105, 40, 115, 60};
  landmarks[0].kind = LandmarkKind::goalBlue;
  EXPECT_TRUE(pinkIsNoBeacon(goodPatch(), landmarks, {}));
  landmarks[0].kind = LandmarkKind::beaconBlueOnPink;
  EXPECT_FALSE(pinkIsNoBeacon(goodPatch(), landmarks, {}));
  landmarks[0].box = {120, 40, 130, 60};
  EXPECT_TRUE(pinkIsNoBeacon(goodPatch(), landmarks, {}));
}

TEST(PinkChecks, GroundAndCarpetDecideAtTheirLimits) {
  PinkPatch patch = goodPatch();
  EXPECT_TRUE(pinkStandsOnGround(patch, {}));
  patch.lift = 3;
  EXPECT_FALSE(pinkStandsOnGround(patch, {}));
  EXPECT_TRUE(pinkIsInsideFieldEdge(patch, {}));
  patch.carpetBehind = 1;
  EXPECT_FALSE(pinkIsInsideFieldEdge(patch, {}));
  patch.carpetBehind = kUnknownBehind;
  EXPECT_FALSE(pinkIsInsideFieldEdge(patch, {}));
  patch.foot.distance = 80;
  EXPECT_TRUE(pinkIsInsideFieldEdge(patch, {}));
}

}  // namespace
}  // namespace kelpie::vision
