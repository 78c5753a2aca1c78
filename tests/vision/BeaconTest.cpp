// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>

#include "tests/vision/Board.h"
#include "tests/vision/Painting.h"
#include "vision/Refusal.h"
#include "vision/beacon/BeaconFinder.h"

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

TEST(Beacon, AtTheCarpetsEdgeBeforeTheGoalOfItsColourIsFound) {
  Painting p = beaconAt(200, 0, kPinkPaint, kBluePaint);
  p.carpetEnd = 220;
  addGoal(p, -10, 225, kBluePaint);
  const Seen seen = look(p, cameraAt(16, 0, 0));
  EXPECT_NE(find(seen.percepts, LandmarkKind::beaconPinkOnBlue), nullptr);
}

TEST(Beacon, PinkAloneIsRefused) {
  const Seen seen = look(beaconAt(150, 0, kPinkPaint, kPinkPaint), cameraAt(16, 0, 0));
  EXPECT_TRUE(seen.percepts.landmarks.empty());
  // Tried upwards from the white, and from the pink's middle up and down.
  EXPECT_EQ(refused(seen, Refusal::beaconNoPartner), 3);
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

TEST(Beacon, BeforeTrousersOfItsUpperColourIsFound) {
  // A spectator in blue right behind it: the upper band has no end above and beside it.
  Painting p = beaconAt(180, 5, kBluePaint, kPinkPaint);
  const double x = p.beacons[0].centre.x;
  p.walls.push_back({{x - 20, 230}, {x + 20, 230}, 32, 110, kBluePaint});
  p.noise = 3.0;
  const Seen seen = look(p, cameraAt(16, 5, 3));
  const auto* beacon = find(seen.percepts, LandmarkKind::beaconBlueOnPink);
  ASSERT_NE(beacon, nullptr);
  EXPECT_NEAR(beacon->distance, 180, 18);  // by the lower band alone, 11 px high
  EXPECT_NEAR(beacon->heading.deg(), 5.0, 0.7);
}

TEST(Beacon, InTheMiddleOfTheCarpetIsRefused) {
  Painting p = beaconAt(150, 0, kBluePaint, kPinkPaint);
  p.carpetEnd = 400;
  const Seen seen = look(p, cameraAt(16, 0, 0));
  EXPECT_TRUE(seen.percepts.landmarks.empty());
  EXPECT_GE(refused(seen, Refusal::beaconOffFieldEdge), 1);
}

TEST(Beacon, OfHalfTheSizeIsRefusedByItsHeight) {
  Painting p = beaconAt(150, 0, kBluePaint, kPinkPaint);
  p.beacons[0].bandHeight = 5;
  p.beacons[0].radius = 2.5;
  const Seen seen = look(p, cameraAt(14, 0, 0));
  EXPECT_TRUE(seen.percepts.landmarks.empty());
  EXPECT_GE(refused(seen, Refusal::beaconElevation), 1);
}

TEST(BeaconChecks, WhatFitsItsHeightMayBeCutByTwoBorders) {
  BeaconCandidate c;
  c.topCut = c.widthCut = true;
  EXPECT_FALSE(beaconIsInImage(c));
  c.sure = true;
  EXPECT_TRUE(beaconIsInImage(c));
}

TEST(BeaconChecks, BandsAreOfOneHeightUnlessTheBorderCutsOne) {
  const BeaconFinderParams p;
  BeaconCandidate c;
  c.upper = 10;
  c.lower = 16.9;  // 1.6 * 10 + 1 = 17
  EXPECT_TRUE(beaconBandsAreEqual(c, p));
  c.lower = 17.1;
  EXPECT_FALSE(beaconBandsAreEqual(c, p));
  c.topCut = true;
  EXPECT_TRUE(beaconBandsAreEqual(c, p));
}

TEST(BeaconChecks, BandIsAboutAsWideAsHigh) {
  const BeaconFinderParams p;
  BeaconCandidate c;
  c.upper = c.lower = 10;
  c.width = 16.9;  // 1.6 * 10 + 1 = 17
  EXPECT_TRUE(beaconBandIsSquare(c, p));
  c.width = 17.1;
  EXPECT_FALSE(beaconBandIsSquare(c, p));
  c.width = 5.7;  // 1.6 * 5.7 + 1 = 10.12
  EXPECT_TRUE(beaconBandIsSquare(c, p));
  c.width = 5.6;
  EXPECT_FALSE(beaconBandIsSquare(c, p));
}

TEST(BeaconChecks, BandOfAColourThatGoesOnFarAsideIsPartOfSomethingElse) {
  const BeaconFinderParams p;
  BeaconCandidate c;
  c.width = 10;
  c.widest = 79;
  EXPECT_TRUE(beaconBandsStandAlone(c, p));
  c.widest = 81;
  EXPECT_FALSE(beaconBandsStandAlone(c, p));
  c.bottomCut = true;
  c.widest = 29;
  EXPECT_TRUE(beaconBandsStandAlone(c, p));
  c.widest = 31;
  EXPECT_FALSE(beaconBandsStandAlone(c, p));
  c.onWhite = true;
  EXPECT_TRUE(beaconBandsStandAlone(c, p));
  c.topCut = true;  // trousers over socks look so, and far wider
  c.widest = 81;
  EXPECT_FALSE(beaconBandsStandAlone(c, p));
}

TEST(BeaconChecks, WhereHeightAndSizeDisagreeMoreOfItsWhiteMustShow) {
  const BeaconFinderParams p;
  Board board(cameraAt(16, 0, 0));
  BeaconCandidate c;
  c.upper = c.lower = 20;
  c.bottom = {104, 80};
  const auto passes = [&](int whiteRows, bool sure) {
    board.fill(98, 80, 110, 80 + whiteRows, kWhitePaint);
    board.fill(98, 80 + whiteRows, 110, 125, kGreenPaint);
    c.sure = sure;
    return beaconHasWhiteBelow(board.scene(), c, p);
  };
  EXPECT_FALSE(passes(12, true));  // 0.24 of what is probed
  EXPECT_TRUE(passes(16, true));
  EXPECT_FALSE(passes(16, false));
  EXPECT_TRUE(passes(24, false));
  c.bottom = {104, kUsableBottom - 0.5};  // below the image nothing shows
  c.bottomCut = true;
  EXPECT_FALSE(passes(0, false));
  EXPECT_TRUE(passes(0, true));
}

TEST(BeaconChecks, WeakCuesAreCountedEachForItself) {
  Board board(cameraAt(16, 0, 0));
  BeaconCandidate c;  // 30 cm up at 100 cm, with a camera 16 cm up
  c.distance = 105.0;
  c.onWhite = true;
  c.middle = *body::project(board.body.camera, {0, board.body.camera.position.y + 100, 30});
  c.upper = c.lower = c.width = c.widest = 19.0;
  c.bottom = {c.middle.x, c.middle.y + 19.0};
  board.fill(90, static_cast<int>(c.bottom.y), 120, 155, kWhitePaint);
  EXPECT_EQ(weakCues(board.scene(), c), 0);
  c.widest = 2.0 * c.width;
  EXPECT_EQ(weakCues(board.scene(), c), 1);
  c.widest = 5.0 * c.width;
  EXPECT_EQ(weakCues(board.scene(), c), 2);
  c.width *= 0.6;
  EXPECT_EQ(weakCues(board.scene(), c), 4);  // not square, and so less like a beacon
  board.edges.push_back({80, 80, 20, 0.5});
  EXPECT_EQ(weakCues(board.scene(), c), 5);
  board.fill(90, static_cast<int>(c.bottom.y), 120, 155, kGreenPaint);
  EXPECT_EQ(weakCues(board.scene(), c), 6);
  c.distance = 140.0;
  EXPECT_EQ(weakCues(board.scene(), c), 8);
  c.widthCut = true;
  EXPECT_EQ(weakCues(board.scene(), c), 7);
}

TEST(BeaconChecks, BandCutAtItsSideMayShowSixTenthsOfItsWidth) {
  const BeaconFinderParams p;
  BeaconCandidate c;
  c.upper = c.lower = 10;
  c.width = 4.1;  // of at most 6.8
  EXPECT_FALSE(beaconBandIsSquare(c, p));
  c.widthCut = true;
  EXPECT_TRUE(beaconBandIsSquare(c, p));
  c.width = 3.3;  // of at most 5.5
  EXPECT_FALSE(beaconBandIsSquare(c, p));
}

TEST(BeaconChecks, BothBandsAreLargeEnoughToMeasure) {
  const BeaconFinderParams p;
  BeaconCandidate c;
  c.upper = c.lower = 2.1;
  EXPECT_TRUE(beaconIsLarge(c, p));
  c.upper = 1.9;
  EXPECT_FALSE(beaconIsLarge(c, p));
  c.topCut = true;
  c.upper = 0.7;  // 1.5 * 0.7 + 1 = 2.05
  EXPECT_TRUE(beaconIsLarge(c, p));
  c.upper = 0.6;
  EXPECT_FALSE(beaconIsLarge(c, p));
}

TEST(BeaconChecks, BorderMayCutItOnOneSideOnly) {
  BeaconCandidate c;
  c.topCut = true;
  EXPECT_TRUE(beaconIsInImage(c));
  c.widthCut = true;
  EXPECT_FALSE(beaconIsInImage(c));
  c.topCut = false;
  EXPECT_TRUE(beaconIsInImage(c));
}

// Bands 10 px high end at row 60, white down to 80.
struct Stand {
  Board board{cameraAt(16, 0, 0)};
  BeaconCandidate c;

  explicit Stand(const Paint& below) {
    board.fill(95, 40, 115, 50, kBluePaint);
    board.fill(95, 50, 115, 60, kPinkPaint);
    board.fill(95, 60, 115, 80, kWhitePaint);
    board.fill(0, 80, kImageWidth, kImageHeight, below);
    c.upper = c.lower = 10;
    c.top = {105, 40};
    c.middle = {105, 50};
    c.bottom = {105, 60};
  }
  bool kept() const { return beaconStandsOnField(board.scene(), c); }
};

TEST(BeaconChecks, CarpetOrARobotFollowsBelowTheWhite) {
  EXPECT_TRUE(Stand(kGreenPaint).kept());
  EXPECT_TRUE(Stand(kWhitePaint).kept());   // a robot's shell before it
  EXPECT_TRUE(Stand(kOrangePaint).kept());  // a ball
  EXPECT_FALSE(Stand(kBluePaint).kept());
  EXPECT_FALSE(Stand(kYellowPaint).kept());
}

TEST(BeaconChecks, BeaconCutBelowNeedsNoField) {
  Stand stand(kBluePaint);
  stand.c.bottomCut = true;
  EXPECT_TRUE(stand.kept());
}

}  // namespace
}  // namespace kelpie::vision
