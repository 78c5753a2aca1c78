// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>

#include "tests/vision/Painting.h"
#include "vision/BeaconFinder.h"
#include "vision/Refusal.h"

namespace kelpie::vision {
namespace {

Painting beaconAt(double distance, double leftDegrees, Paint upper, Paint lower) {
  const double h = leftDegrees * 3.14159265358979 / 180.0;
  Painting p;
  p.carpetEnd = distance;
  p.beacons.push_back({{-distance * std::sin(h), distance * std::cos(h)}, upper, lower});
  return p;
}

int refused(const Seen& seen, Refusal reason) {
  return seen.percepts.counts.refused[static_cast<std::size_t>(reason)];
}

TEST(Beacon, EachOfTheFourIsNamedByItsColours) {
  const auto kind = [](Paint upper, Paint lower) {
    const Seen seen = look(beaconAt(150, 5, upper, lower), cameraAt(16, 0, 3));
    return seen.percepts.landmarks.size() == 1 ? seen.percepts.landmarks[0].kind
                                               : LandmarkKind::goalBlue;
  };
  EXPECT_EQ(kind(kBluePaint, kPinkPaint), LandmarkKind::beaconBlueOnPink);
  EXPECT_EQ(kind(kPinkPaint, kBluePaint), LandmarkKind::beaconPinkOnBlue);
  EXPECT_EQ(kind(kYellowPaint, kPinkPaint), LandmarkKind::beaconYellowOnPink);
  EXPECT_EQ(kind(kPinkPaint, kYellowPaint), LandmarkKind::beaconPinkOnYellow);
}

TEST(Beacon, DistanceAndHeadingAreThoseOfThePaintedOne) {
  for (const double d : {80.0, 130.0, 200.0, 300.0, 400.0}) {
    Painting p = beaconAt(d, 10, kPinkPaint, kYellowPaint);
    p.noise = 3.0;
    const Seen seen = look(p, cameraAt(16, 6, 2, 8));
    const auto* beacon = find(seen.percepts, LandmarkKind::beaconPinkOnYellow);
    ASSERT_NE(beacon, nullptr) << d;
    EXPECT_NEAR(beacon->distance, d, 0.04 * d);
    EXPECT_NEAR(beacon->heading.deg(), 10.0, 0.5);
  }
}

TEST(Beacon, MeasuresTheSameWithTheHeadTiltedAndRolled) {
  const Seen seen = look(beaconAt(180, -6, kPinkPaint, kBluePaint), cameraAt(20, -10, -12, 25));
  const auto* beacon = find(seen.percepts, LandmarkKind::beaconPinkOnBlue);
  ASSERT_NE(beacon, nullptr);
  EXPECT_NEAR(beacon->distance, 180, 7);
}

TEST(Beacon, WithItsTopOutsideTheImageIsMeasuredByThePinkBand) {
  const Seen seen = look(beaconAt(100, 0, kBluePaint, kPinkPaint), cameraAt(16, 0, -9));
  const auto* beacon = find(seen.percepts, LandmarkKind::beaconBlueOnPink);
  ASSERT_NE(beacon, nullptr);
  EXPECT_NEAR(beacon->distance, 100, 8);
}

TEST(Beacon, BeforeTheGoalOfItsColourIsFoundAndTheGoalToo) {
  Painting p = beaconAt(200, 0, kPinkPaint, kBluePaint);
  p.carpetEnd = 400;
  addGoal(p, -10, 330, kBluePaint);
  const Seen seen = look(p, cameraAt(16, 0, 0));
  EXPECT_NE(find(seen.percepts, LandmarkKind::beaconPinkOnBlue), nullptr);
}

TEST(Beacon, PinkAloneIsRefused) {
  const Seen seen = look(beaconAt(150, 0, kPinkPaint, kPinkPaint), cameraAt(16, 0, 0));
  EXPECT_TRUE(seen.percepts.landmarks.empty());
  EXPECT_EQ(refused(seen, Refusal::beaconNoPartner), 1);
}

TEST(Beacon, WithoutItsWhiteFootIsRefused) {
  Painting p = beaconAt(150, 0, kBluePaint, kPinkPaint);
  p.beacons[0].foot = kGreenPaint;
  const Seen seen = look(p, cameraAt(16, 0, 0));
  EXPECT_TRUE(seen.percepts.landmarks.empty());
  EXPECT_GE(refused(seen, Refusal::beaconNoWhiteBelow), 1);
}

TEST(Beacon, PinkShirtOverBlueTrousersIsRefused) {
  Painting p;
  p.carpetEnd = 250;
  p.walls.push_back({{-20, 330}, {20, 330}, 85, 145, kPinkPaint});
  p.walls.push_back({{-20, 330}, {20, 330}, 5, 85, kBluePaint});
  const Seen seen = look(p, cameraAt(16, 0, 5));
  EXPECT_EQ(find(seen.percepts, LandmarkKind::beaconPinkOnBlue), nullptr);
}

TEST(Beacon, HoveringHighInTheAirIsRefused) {
  Painting p = beaconAt(250, 0, kBluePaint, kPinkPaint);
  p.beacons[0].lift = 60;
  const Seen seen = look(p, cameraAt(16, 0, 10));
  EXPECT_TRUE(seen.percepts.landmarks.empty());
  EXPECT_GE(refused(seen, Refusal::beaconElevation), 1);
}

TEST(Beacon, LyingFarBelowTheHorizonIsRefused) {
  Painting p = beaconAt(80, 0, kBluePaint, kPinkPaint);
  p.beacons[0].bandHeight = 3;
  p.beacons[0].radius = 1.5;
  const Seen seen = look(p, cameraAt(40, 0, -20));
  EXPECT_TRUE(seen.percepts.landmarks.empty());
  EXPECT_GE(refused(seen, Refusal::beaconBelowHorizon), 1);
}

TEST(BeaconChecks, BandsAndAspectDecideAtTheirLimits) {
  const BeaconParams p;
  BeaconCandidate c;
  c.distance = 150;
  c.upper = 10;
  c.lower = 20;
  EXPECT_TRUE(beaconBandsAreEqual(c, p));
  c.lower = 22;
  EXPECT_FALSE(beaconBandsAreEqual(c, p));
  c.topCut = true;
  EXPECT_TRUE(beaconBandsAreEqual(c, p));
  c.width = 17;  // of the pink upper band, 10 high; 13 cm at 150
  c.topCut = false;
  EXPECT_TRUE(beaconBandIsSquare(c, p));
  c.width = 24;  // 18 cm
  EXPECT_FALSE(beaconBandIsSquare(c, p));
  c.width = 3;
  EXPECT_FALSE(beaconBandIsSquare(c, p));
  c.bothSides = true;
  EXPECT_FALSE(beaconHasOnePartner(c));
}

}  // namespace
}  // namespace kelpie::vision
