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

// Bands 10 px high and wide end at row 60, white down to 80, and below that what `below` is.
struct Stand {
  Board board{cameraAt(16, 0, 0)};
  BeaconCandidate c;

  explicit Stand(const Paint& below = kGreenPaint) {
    board.fill(100, 40, 110, 50, kBluePaint);
    board.fill(100, 50, 110, 60, kPinkPaint);
    board.fill(100, 60, 110, 80, kWhitePaint);
    board.fill(0, 80, kImageWidth, kImageHeight, below);
    c.partner = ColourClass::blue;
    c.pinkIsLower = c.onWhite = true;
    c.upper = c.lower = c.width = c.widest = 10;
    c.distance = 200;
    c.top = {105, 40};
    c.middle = {105, 50};
    c.bottom = {105, 60};
  }
  BeaconFacts facts() const { return beaconFacts(board.scene(), c); }
};

TEST(BeaconFacts, BandsOfAWholeBeaconAreEqualAndSquareAndFilledAndStandAlone) {
  const BeaconFacts facts = Stand().facts();
  EXPECT_EQ(facts.band, 10);
  EXPECT_NEAR(facts.bandRatio, 0, 1e-9);
  EXPECT_NEAR(facts.aspect, 0, 1e-9);
  EXPECT_NEAR(facts.wider, 0, 1e-9);
  EXPECT_EQ(facts.filled, 1);
  EXPECT_EQ(facts.beside, 0);
  EXPECT_EQ(facts.whiteShare, 1);
  EXPECT_EQ(facts.whiteShows, 1);
}

TEST(BeaconFacts, UnequalBandsDifferByTheLogOfTheirRatioUnlessOneIsCut) {
  Stand stand;
  stand.c.upper = 15;
  EXPECT_NEAR(stand.facts().bandRatio, std::log(1.5), 1e-6);
  stand.c.topCut = true;
  EXPECT_EQ(stand.facts().bandRatio, 0);
  EXPECT_EQ(stand.facts().topCut, 1);
}

TEST(BeaconFacts, ImageBorderExplainsANarrowBandButNoneThatIsTooWide) {
  Stand stand;
  stand.c.widthCut = true;
  stand.c.width = 5;
  EXPECT_EQ(stand.facts().widthCut, 1);
  stand.c.width = 15;
  EXPECT_EQ(stand.facts().widthCut, 0);
}

TEST(BeaconFacts, ClothesOfItsColourBesideABandAreSeenThere) {
  Stand stand;
  stand.board.fill(60, 40, 100, 50, kBluePaint);
  EXPECT_NEAR(stand.facts().beside, 0.25, 1e-9);  // one side of one of the two bands
}

TEST(BeaconFacts, PatternedClothesDoNotFillTheBands) {
  Stand stand;
  stand.board.fill(100, 43, 110, 47, kWhitePaint);
  EXPECT_LT(stand.facts().filled, 0.9);
}

TEST(BeaconFacts, FootIsThreeBandsBelowTheBordersOfTheColours) {
  Stand stand;
  EXPECT_EQ(stand.facts().edgeShows, 0);
  stand.board.edges.push_back({70, 70, 20, 0.5});
  EXPECT_EQ(stand.facts().edgeShows, 1);
  EXPECT_NEAR(stand.facts().footBelowEdge, 1.0, 0.05);  // at row 80, in bands of 10 px
}

TEST(BeaconFacts, CarpetOrARobotOrTheBallBelowTheWhiteIsNotStrange) {
  EXPECT_EQ(Stand(kGreenPaint).facts().strangeBelow, 0);
  EXPECT_EQ(Stand(kWhitePaint).facts().strangeBelow, 0);   // a robot's shell before it
  EXPECT_EQ(Stand(kOrangePaint).facts().strangeBelow, 0);  // a ball
  EXPECT_GT(Stand(kBluePaint).facts().strangeBelow, 0.6);
  EXPECT_GT(Stand(kYellowPaint).facts().strangeBelow, 0.6);
}

TEST(BeaconFacts, NothingBelowABeaconThatIsCutThereIsStrange) {
  Stand stand(kBluePaint);
  stand.c.bottomCut = true;
  EXPECT_EQ(stand.facts().strangeBelow, 0);
}

// Of a beacon at 200 cm with a camera 16 cm up, as most candidates for one have them.
BeaconFacts factsOfAWholeBeacon() {
  BeaconFacts facts;
  facts.distance = 200;
  facts.band = 9.6;
  facts.bandRatio = 0.04;
  facts.footBelowEdge = 0.15;
  facts.elevationError = 0.1;
  facts.belowHorizon = -14;
  facts.whiteShare = facts.whiteShows = facts.edgeShows = facts.filled = facts.onWhite = 1;
  return facts;
}

TEST(BeaconFacts, OneWeakFactDoesNotMakeAWholeBeaconUnlikely) {
  const BeaconFinderParams p;
  const BeaconFacts whole = factsOfAWholeBeacon();
  BeaconFacts uneven = whole;
  uneven.bandRatio = 0.25;
  BeaconFacts touched = whole;
  touched.beside = 0.25;
  BeaconFacts hidden = whole;
  hidden.whiteShare = 0.6;
  for (const BeaconFacts& facts : {uneven, touched, hidden}) {
    EXPECT_GT(logOddsAgainst(facts), logOddsAgainst(whole));
    EXPECT_LE(logOddsAgainst(facts), p.maxLogOddsAgainst);
  }
}

TEST(BeaconFacts, SeveralWeakFactsDo) {
  BeaconFacts facts = factsOfAWholeBeacon();
  facts.bandRatio = 0.4;
  facts.elevationError = 1.4;
  facts.whiteShare = 0.2;
  facts.footBelowEdge = -1.5;
  facts.filled = 0.7;
  EXPECT_GT(logOddsAgainst(facts), BeaconFinderParams().maxLogOddsAgainst);
}

}  // namespace
}  // namespace kelpie::vision
