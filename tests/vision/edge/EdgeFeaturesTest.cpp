// SPDX-License-Identifier: Apache-2.0
// Made-up scan lines: an image whose columns are all painted alike, from the top to the bottom.
#include <gtest/gtest.h>

#include <initializer_list>
#include <memory>

#include "tests/vision/Painting.h"
#include "vision/VisionState.h"
#include "vision/edge/EdgeFeatures.h"

namespace kelpie::vision {
namespace {

struct Band {
  ColourClass colour;
  int rows;
};

constexpr ColourClass kGreen = ColourClass::green;
constexpr ColourClass kFloor = ColourClass::none;

// Fills the memory of classes: what is not painted is green.
EdgeFeatures featuresOf(std::initializer_list<Band> bands, double up = -5.0) {
  const auto image = std::make_unique<Image>();
  const auto state = stateForPaintings();
  for (std::size_t i = 0; i < kImagePixels; ++i)
    state->classes.keep(i, static_cast<unsigned>(kGreen));
  int row = 0;
  for (const Band& band : bands)
    for (int i = 0; i < band.rows; ++i, ++row)
      for (int x = 0; x < kImageWidth; ++x)
        state->classes.keep(Image::at(x, row), static_cast<unsigned>(band.colour));
  const Sampler sampler(*image, state->tables, state->classes);
  return edgeFeatures(sampler, horizonScan(Lattice(horizonFrameOf(cameraAt(16, 0, up))), {}), {});
}

TEST(EdgeFeatures, OneOnEachScanLineWhereTheGreenEnds) {
  const EdgeFeatures features = featuresOf({{kFloor, 70}});
  ASSERT_EQ(features.size(), 51U);
  for (const EdgeFeature& f : features) {
    EXPECT_NEAR(f.at.y, 70.0, 0.01);
    EXPECT_FALSE(f.open);
    EXPECT_EQ(f.weight, 1.0);
  }
}

TEST(EdgeFeatures, ALineOnTheCarpetMakesNone) {
  const EdgeFeatures features = featuresOf({{kFloor, 70}, {kGreen, 20}, {ColourClass::white, 6}});
  ASSERT_EQ(features.size(), 51U);
  EXPECT_NEAR(features[20].at.y, 70.0, 0.01);
}

TEST(EdgeFeatures, CarpetBeyondALineNearTheEdgeCounts) {
  // 6 px of green, a line of 2 px, then the field: the fringe at about 1 m.
  const EdgeFeatures features = featuresOf({{kFloor, 70}, {kGreen, 6}, {ColourClass::white, 2}});
  ASSERT_EQ(features.size(), 51U);
  EXPECT_NEAR(features[20].at.y, 70.0, 0.01);
}

TEST(EdgeFeatures, SpecksOfGreenAndOfNothingTriggerNone) {
  const EdgeFeatures features =
      featuresOf({{kFloor, 60}, {kGreen, 2}, {kFloor, 10}, {kGreen, 4}, {kFloor, 1}});
  ASSERT_EQ(features.size(), 51U);
  EXPECT_NEAR(features[20].at.y, 72.0, 0.01);
}

TEST(EdgeFeatures, BallAndUniformHideCarpetThatGoesOn) {
  for (const ColourClass c : {ColourClass::orange, ColourClass::robotRed, ColourClass::robotBlue}) {
    const EdgeFeatures features = featuresOf({{kFloor, 70}, {c, 20}});
    ASSERT_EQ(features.size(), 51U);
    EXPECT_TRUE(features[20].open);
  }
}

TEST(EdgeFeatures, FootOfAGoalIsDoubtful) {
  const EdgeFeatures features = featuresOf({{kFloor, 70}, {ColourClass::blue, 20}});
  ASSERT_EQ(features.size(), 51U);
  EXPECT_FALSE(features[20].open);
  EXPECT_LT(features[20].weight, 1.0);
  EXPECT_TRUE(features[20].atGoal);
}

TEST(EdgeFeatures, GreenUpToTheImageBorderGoesOn) {
  const EdgeFeatures features = featuresOf({}, -45.0);
  ASSERT_EQ(features.size(), 25U);
  EXPECT_TRUE(features[20].open);
  const EdgeFeatures line = featuresOf({{ColourClass::white, 14}}, -45.0);
  ASSERT_EQ(line.size(), 25U);
  EXPECT_TRUE(line[20].open) << "a line that leaves through the image's top";
}

TEST(EdgeFeatures, GreenThatReachesAboveTheHorizonIsNoCarpet) {
  EXPECT_TRUE(featuresOf({}, 0.0).empty());
}

TEST(EdgeFeatures, NoneWithoutGreen) { EXPECT_TRUE(featuresOf({{kFloor, 160}}).empty()); }

}  // namespace
}  // namespace kelpie::vision
