// SPDX-License-Identifier: Apache-2.0
// Each check of a uniform's patch at its limit, on plain numbers.
#include <gtest/gtest.h>

#include <memory>

#include "tests/vision/PaintedRobot.h"
#include "vision/robot/RobotFinder.h"

namespace kelpie::vision {
namespace {

struct EmptyScene {
  std::unique_ptr<VisionState> state = std::make_unique<VisionState>();
  std::unique_ptr<Image> image = std::make_unique<Image>();
  Sampler sampler{*image, state->tables, state->classes};
  BodyState body = bodyOf(cameraAt(17, 0, -8));
  FixedVector<FieldEdgePercept, 3> edges;
  Lattice lattice{horizonFrameOf(body.camera)};
  body::FieldDescription field = *body::fieldDescription("2006");
  Scene scene{sampler, state->blobs, body, edges, lattice.frame(), lattice, state->runs, field};
};

RobotPatch goodPatch() {
  RobotPatch patch;
  patch.samples = 20;
  patch.centre = {100, 60};
  patch.extent = {4, 4, 3, 3};
  patch.foot = {FootEnd::carpet, {100, 80}, 120};
  patch.distance = 120;
  patch.scale = 1.6;
  patch.height = 12;
  patch.carpetBehind = 9;
  patch.shellShare = 0.8;
  patch.ownShare = 1.0;
  patch.meanIsOwn = true;
  return patch;
}

TEST(RobotChecks, ShareOfItsOwnColour) {
  const RobotFinderParams p;
  RobotPatch patch = goodPatch();
  EXPECT_TRUE(robotPatchHasColour(patch, p));
  patch.ownShare = p.minOwnShare - 0.01;
  EXPECT_FALSE(robotPatchHasColour(patch, p));
}

TEST(RobotChecks, ElevationOfThePatch) {
  const EmptyScene empty;
  RobotPatch patch = goodPatch();
  EXPECT_TRUE(robotPatchIsLow(empty.scene, patch, {}));
  patch.centre.y = 2;
  EXPECT_FALSE(robotPatchIsLow(empty.scene, patch, {}));
}

TEST(RobotChecks, SizeAtItsDistance) {
  RobotPatch patch = goodPatch();
  EXPECT_TRUE(robotPatchHasSize(patch, {}));
  patch.extent.left = 40;
  EXPECT_FALSE(robotPatchHasSize(patch, {}));
  patch = goodPatch();
  patch.extent.upper = 40;
  EXPECT_FALSE(robotPatchHasSize(patch, {}));
}

TEST(RobotChecks, OtherColoursMatterOnlyWithoutCarpetBehind) {
  RobotPatch patch = goodPatch();
  patch.foreignShare = 0.6;
  EXPECT_TRUE(robotPatchIsPure(patch, {}));
  patch.carpetBehind = 3;
  EXPECT_FALSE(robotPatchIsPure(patch, {}));
  patch.foreignShare = 0.0;
  EXPECT_TRUE(robotPatchIsPure(patch, {}));
  patch.meanIsOwn = false;
  EXPECT_FALSE(robotPatchIsPure(patch, {}));
}

TEST(RobotChecks, ATallPatchIsATrouserLeg) {
  RobotPatch patch = goodPatch();
  patch.extent = {1.5, 1.5, 7, 8};
  EXPECT_FALSE(robotPatchHasSize(patch, {}));
  patch.extent = {3, 2, 7, 8};
  EXPECT_TRUE(robotPatchHasSize(patch, {}));
}

TEST(RobotChecks, SpecksNeedCarpetBehind) {
  RobotPatch patch = goodPatch();
  patch.carpetBehind = 3;
  EXPECT_TRUE(robotPatchIsPure(patch, {}));
  patch.samples = 40;  // 160 px in an extent of 48
  EXPECT_FALSE(robotPatchIsSolid(patch));
  EXPECT_FALSE(robotPatchIsPure(patch, {}));
  patch.carpetBehind = 9;
  EXPECT_TRUE(robotPatchIsPure(patch, {}));
}

TEST(RobotChecks, ShellRoundThePatch) {
  RobotPatch patch = goodPatch();
  EXPECT_TRUE(robotHasShell(patch, {}));
  patch.shellShare = RobotFinderParams{}.minShell - 0.01;
  EXPECT_FALSE(robotHasShell(patch, {}));
}

TEST(RobotChecks, FootIsBelowTheFieldEdge) {
  EmptyScene empty;
  RobotPatch patch = goodPatch();
  EXPECT_TRUE(robotIsInsideFieldEdge(empty.scene, patch, {}));
  const double row = patch.foot.pixel.y - RobotFinderParams{}.minInsideFieldEdge;
  empty.edges.push_back({row - 0.2, row - 0.2});
  EXPECT_TRUE(robotIsInsideFieldEdge(empty.scene, patch, {}));
  empty.edges[0] = {row + 0.2, row + 0.2};
  EXPECT_FALSE(robotIsInsideFieldEdge(empty.scene, patch, {}));
}

TEST(RobotChecks, StandsAFootInsideTheCarpetsEdge) {
  const EmptyScene empty;
  const double min = RobotFinderParams{}.minCarpetBeyond;
  RobotPatch patch = goodPatch();
  patch.carpetBeyond = min - 1;
  EXPECT_FALSE(robotIsInsideFieldEdge(empty.scene, patch, {}));
  patch.carpetBeyond = min + 1;
  EXPECT_TRUE(robotIsInsideFieldEdge(empty.scene, patch, {}));
  patch.carpetBeyond = min - 1;
  patch.foot.end = FootEnd::imageBorder;  // its feet are nearer than what the border shows
  EXPECT_TRUE(robotIsInsideFieldEdge(empty.scene, patch, {}));
}

TEST(RobotChecks, CarpetBeyondTheFootIsMeasuredAlongTheGround) {
  EmptyScene scene;
  RobotPatch patch = goodPatch();
  measureSurroundings(scene.scene, patch);
  EXPECT_EQ(patch.carpetBeyond, kNoDistance);
  const auto foot = groundDistance(scene.body.camera, {100, 90});
  const auto edge = groundDistance(scene.body.camera, {100, 80});
  ASSERT_TRUE(foot && edge);
  patch.foot = {FootEnd::carpet, {100, 90}, *foot};
  scene.edges.push_back({80, 80});
  measureSurroundings(scene.scene, patch);
  EXPECT_NEAR(patch.carpetBeyond, *edge - *foot, 0.01);
}

RobotFacts factsOfATrunk() {
  RobotFacts facts;
  facts.patches = 2;
  facts.samples = 20;
  facts.ownShare = 0.95;
  facts.meanIsOwn = 1;
  facts.patchWidth = 7;
  facts.patchHeight = 4;
  facts.heightError = 3;
  facts.carpetBeyond = 90;
  facts.footBelowEdge = 15;
  return facts;
}

TEST(RobotFacts, OneWeakFactDoesNotMakeATrunkUnlikely) {
  const RobotFinderParams p;
  RobotFacts single = factsOfATrunk();
  EXPECT_LE(logOddsAgainst(single), p.maxLogOddsAgainst);
  single.patches = 1;
  RobotFacts atTheEdge = factsOfATrunk();
  atTheEdge.carpetBeyond = 22;
  RobotFacts mixed = factsOfATrunk();
  mixed.ownShare = 0.6;
  for (const RobotFacts& facts : {single, atTheEdge, mixed}) {
    EXPECT_GT(logOddsAgainst(facts), logOddsAgainst(factsOfATrunk()));
    EXPECT_LE(logOddsAgainst(facts), p.maxLogOddsAgainst);
  }
}

TEST(RobotFacts, ASmallMixedPatchAtTheEdgeIsNoRobot) {
  RobotFacts facts = factsOfATrunk();
  facts.patches = 1;
  facts.ownShare = 0.5;
  facts.patchHeight = 2;
  facts.carpetBeyond = 12;
  facts.footBelowEdge = 2;
  EXPECT_GT(logOddsAgainst(facts), RobotFinderParams{}.maxLogOddsAgainst);
}

TEST(RobotFacts, FeetCutOffCountAgainstARobot) {
  const RobotFacts facts = factsOfATrunk();
  RobotFacts cut = facts;
  cut.footCut = 1;
  EXPECT_GT(logOddsAgainst(cut), logOddsAgainst(facts));
}

TEST(RobotFacts, FactsAreThoseOfThePatch) {
  RobotPatch patch = goodPatch();
  patch.height = 20;
  patch.carpetBehind = kUnknownBehind;
  patch.foot.end = FootEnd::imageBorder;
  const RobotFacts facts = robotFacts(EmptyScene{}.scene, patch);
  EXPECT_EQ(facts.patchWidth, 8 / 1.6);
  EXPECT_EQ(facts.patchHeight, 6 / 1.6);
  EXPECT_EQ(facts.heightError, 6.0);
  EXPECT_EQ(facts.footCut, 1.0);
  EXPECT_EQ(facts.ownShare, 1.0);
}

TEST(RobotChecks, WithoutCarpetOrEdgeInTheImageOnlyACleanPatchIsBelieved) {
  const EmptyScene empty;
  RobotPatch patch = goodPatch();
  patch.carpetBehind = kUnknownBehind;
  EXPECT_TRUE(robotIsInsideFieldEdge(empty.scene, patch, {}));
  patch.foreignShare = 0.25;
  EXPECT_FALSE(robotIsInsideFieldEdge(empty.scene, patch, {}));
}

TEST(RobotChecks, HeightAboveTheGround) {
  RobotPatch patch = goodPatch();
  EXPECT_TRUE(robotStandsOnGround(patch, {}));
  patch.height = 30;
  EXPECT_FALSE(robotStandsOnGround(patch, {}));
  patch = goodPatch();
  patch.foot.end = FootEnd::hidden;
  EXPECT_FALSE(robotStandsOnGround(patch, {}));
}

TEST(RobotChecks, FeetCutOffAreBelievedNearOnly) {
  RobotPatch patch = goodPatch();
  EXPECT_TRUE(robotIsNear(patch, {}));
  patch.foot.end = FootEnd::imageBorder;
  patch.carpetBehind = 3;
  EXPECT_FALSE(robotIsNear(patch, {}));
  patch.distance = 69;
  EXPECT_TRUE(robotIsNear(patch, {}));
  patch.ownShare = 0.7;  // other colours on it
  EXPECT_FALSE(robotIsNear(patch, {}));
  patch.distance = 49;
  EXPECT_TRUE(robotIsNear(patch, {}));
}

TEST(RobotChecks, APatchCutByTheImageIsNoMeasure) {
  RobotPatch patch = goodPatch();
  patch.scale = 3.6;  // 6 px are 1.7 cm, less than a whole patch's 5.5
  patch.distance = 50;
  EXPECT_TRUE(robotPatchHasSize(patch, {}));
  patch.foot.end = FootEnd::imageBorder;
  EXPECT_FALSE(robotPatchHasSize(patch, {}));
}

TEST(RobotChecks, ASpeckNeedsMoreShellAroundIt) {
  RobotPatch patch = goodPatch();
  patch.shellShare = 0.5 * (RobotFinderParams{}.minShell + RobotFinderParams{}.minShellOfFew);
  EXPECT_TRUE(robotHasShell(patch, {}));
  patch.samples = RobotFinderParams{}.fewSamples - 1;
  EXPECT_FALSE(robotHasShell(patch, {}));
}

TEST(RobotChecks, ASpeckIsBelievedFarAwayOrBeforeMuchCarpet) {
  const double few = RobotFinderParams{}.fewSamples;
  RobotPatch patch = goodPatch();
  patch.samples = few;
  patch.carpetBehind = 5;
  EXPECT_TRUE(robotIsNoSpeck(patch, {}));
  patch.distance = 59;
  EXPECT_FALSE(robotIsNoSpeck(patch, {}));
  patch.carpetBehind = 6;
  EXPECT_TRUE(robotIsNoSpeck(patch, {}));
  patch.carpetBehind = 5;
  patch.samples = few + 1;
  EXPECT_TRUE(robotIsNoSpeck(patch, {}));
}

TEST(RobotChecks, FeetAreNotCutByABorderThatShowsTheGroundFarBehind) {
  RobotPatch patch = goodPatch();
  patch.foot = {FootEnd::imageBorder, {100, 158}, 71};
  patch.distance = 30;
  EXPECT_TRUE(robotFeetMayBeCut(patch, {}));
  patch.foot.distance = 73;
  EXPECT_FALSE(robotFeetMayBeCut(patch, {}));
  patch.foot.end = FootEnd::carpet;
  EXPECT_TRUE(robotFeetMayBeCut(patch, {}));
}

TEST(RobotGroups, PatchesAreOfOneRobotWhenNearAndOfOneTeam) {
  const PatchGroup a = groupOf(goodPatch(), {});
  RobotPatch patch = goodPatch();
  patch.centre.x += 20;  // 12.5 cm
  EXPECT_TRUE(areOfOneRobot(a, groupOf(patch, {}), {}));
  patch.team = TeamColour::blue;
  EXPECT_FALSE(areOfOneRobot(a, groupOf(patch, {}), {}));
  patch.team = TeamColour::red;
  patch.centre.x += 40;
  EXPECT_FALSE(areOfOneRobot(a, groupOf(patch, {}), {}));
}

TEST(RobotGroups, FeetInTheImageCountMoreThanFeetCutOff) {
  PatchGroup cut = groupOf(goodPatch(), {});
  cut.cut = true;
  cut.distance = 50;
  const PatchGroup whole = groupOf(goodPatch(), {});
  EXPECT_NEAR(joined(cut, whole).distance, 120, 1e-9);
  EXPECT_NEAR(joined(whole, cut).distance, 120, 1e-9);
}

TEST(RobotGroups, ADubiousPartOnlyBringsTheRobotNearer) {
  const PatchGroup head = groupOf(goodPatch(), {});
  PatchGroup trunk = head;
  trunk.distance = 70;
  trunk.cut = true;
  EXPECT_NEAR(nearer(head, trunk).distance, 70, 1e-9);
  EXPECT_TRUE(nearer(head, trunk).cut);
  trunk.distance = 150;
  EXPECT_NEAR(nearer(head, trunk).distance, 120, 1e-9);
  EXPECT_FALSE(nearer(head, trunk).cut);
}

TEST(RobotChecks, OnlyALargePatchOfARobotsHeightTellsItsDistance) {
  const RobotFinderParams p;
  RobotPatch patch = goodPatch();
  EXPECT_TRUE(robotPatchTellsDistance(patch, p));
  patch.samples = p.partSamples - 1;
  EXPECT_FALSE(robotPatchTellsDistance(patch, p));
  patch = goodPatch();
  patch.height = p.maxHeight + 1;
  EXPECT_FALSE(robotPatchTellsDistance(patch, p));
  patch = goodPatch();
  patch.foot.end = FootEnd::hidden;
  EXPECT_FALSE(robotPatchTellsDistance(patch, p));
}

}  // namespace
}  // namespace kelpie::vision
