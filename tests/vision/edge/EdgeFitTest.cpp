// SPDX-License-Identifier: Apache-2.0
// The fit on made-up features; `kelpie evaluate field-edge` has the whole table of checklist E4.
#include <gtest/gtest.h>

#include <cmath>

#include "robot/body/Camera.h"
#include "robot/core/Random.h"
#include "tests/vision/Painting.h"
#include "vision/Refusal.h"
#include "vision/Scene.h"
#include "vision/edge/EdgeFit.h"
#include "vision/edge/FieldEdge.h"

namespace kelpie::vision {
namespace {

constexpr int kPoints = 48;
double columnOf(int i) { return 4.5 + 4 * i; }

FieldEdges edgesOf(const EdgeFeatures& features, const HorizonFrame& frame = {}) {
  VisionCounts counts;
  return edgeRows(fitEdgeLines(features, frame, {}, counts));
}

// Features along rows that a function of the column gives, with 0.4 px of noise as in the images.
template <class Rows>
EdgeFeatures along(Rows rows, double noise = 0.4, std::uint64_t seed = 1) {
  Random random(seed);
  EdgeFeatures features;
  for (int i = 0; i < kPoints; ++i)
    features.push_back({{columnOf(i), rows(columnOf(i)) + noise * random.gaussian()}, false, 1.0});
  return features;
}

// Checklist E4 with half of the points wrong: within 6 px at both image borders.
TEST(EdgeFit, SurvivesHalfOfThePointsWrongOnALevelLine) {
  Random random(5);
  int good = 0;
  for (int trial = 0; trial < 300; ++trial) {
    EdgeFeatures features = along([](double) { return 60.0; }, 1.0, random.next());
    for (int i = 0; i < kPoints; ++i)
      if (random.chance(0.5)) features[static_cast<std::size_t>(i)].at.y = random.uniform(0, 160);
    const FieldEdges edges = edgesOf(features);
    good +=
        std::fabs(fieldEdgeRow(edges, 0) - 60) < 6 && std::fabs(fieldEdgeRow(edges, 208) - 60) < 6
            ? 1
            : 0;
  }
  EXPECT_GE(good, 285) << "required are 95 %";
}

TEST(EdgeFit, AnObstaclesFootIsNotTheEdgeThoughItCoversHalf) {
  const auto rows = [](double x) { return x < 100 ? 60.0 + 0.05 * x : 100.0 - 0.1 * (x - 100); };
  const FieldEdges edges = edgesOf(along(rows));
  ASSERT_EQ(edges.size(), 1U);
  EXPECT_NEAR(edges[0].atLeft, 60.0, 2.0);
  EXPECT_NEAR(edges[0].atRight, 70.4, 2.0);
}

TEST(EdgeFit, UprightLinesAreNoException) {
  EdgeFeatures features;
  for (int i = 0; i < 30; ++i) features.push_back({{90.0, 5.0 * i}, false, 1.0});
  VisionCounts counts;
  const HorizonFrame rolled{0.0, 1.0, -60.0, Lens{}};  // up is to the right
  const EdgeLines lines = fitEdgeLines(features, rolled, {}, counts);
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_NEAR(lines[0].nx, 1.0, 1e-9);
  EXPECT_NEAR(lines[0].offset, 90.0, 1e-6);
  EXPECT_TRUE(edgeRows(lines).empty()) << "no row says it";
}

TEST(EdgeFit, ACornerGivesTwoEdges) {
  // 16 cm above the carpet, its corner 150 cm ahead, both borders 45 deg to the view.
  const auto row = [](double x) { return 63.2 + 16.0 / 150.0 * (192.0 - std::fabs(x - 104.0)); };
  const HorizonFrame frame = horizonFrameOf(cameraAt(16, 0, -5));
  const FieldEdges edges = edgesOf(along(row), frame);
  ASSERT_EQ(edges.size(), 1U) << "a corner that points at the robot is not convex";
  const auto convex = [](double x) {
    return 63.2 + 20.5 - 0.107 * (192.0 - std::fabs(x - 104.0)) + 20;
  };
  const FieldEdges both = edgesOf(along(convex), frame);
  ASSERT_EQ(both.size(), 2U);
  EXPECT_NEAR(fieldEdgeRow(both, 104.0), convex(104.0), 1.0);
  EXPECT_NEAR(fieldEdgeRow(both, 0.0), convex(0.0), 1.5);
  EXPECT_NEAR(fieldEdgeRow(both, 208.0), convex(208.0), 1.5);
}

TEST(EdgeFit, NoiseMakesNoCorner) {
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    const EdgeFeatures features = along([](double x) { return 90.0 + 0.1 * x; }, 1.0, seed);
    EXPECT_EQ(edgesOf(features, horizonFrameOf(cameraAt(16, 0, -5))).size(), 1U) << seed;
  }
}

TEST(EdgeFit, OpenFeaturesBearNoEdgeAndForbidOneBelowThem) {
  EdgeFeatures features = along([](double) { return 90.0; });
  for (EdgeFeature& f : features) f.open = true;
  EXPECT_TRUE(edgesOf(features).empty());
  // A line of 20 features with carpet seen beyond it by 28.
  EdgeFeatures mixed = along([](double x) { return x < 82.0 ? 90.0 : 10.0; });
  for (EdgeFeature& f : mixed) f.open = f.at.x >= 82.0;
  EdgeFeatures higher = mixed;
  for (std::size_t i = 0; i < 10; ++i) higher[i].at.y = 8.0;
  EXPECT_LT(fieldEdgeRow(edgesOf(higher), 104.0), 20.0);
}

TEST(EdgeFit, FeaturesAtAGoalAloneMakeNoEdge) {
  EdgeFeatures features = along([](double) { return 90.0; });
  for (EdgeFeature& f : features) {
    f.weight = 0.5;
    f.atGoal = f.at.x > 8.0;
  }
  EXPECT_TRUE(edgesOf(features).empty()) << "one feature beside the goal is not enough";
  features[2].atGoal = false;
  EXPECT_EQ(edgesOf(features).size(), 1U);
}

TEST(EdgeFit, ScatteredFeaturesSupportNoneAndAreCounted) {
  Random random(6);
  EdgeFeatures features;
  for (int i = 0; i < kPoints; ++i)
    features.push_back({{columnOf(i), random.uniform(5, 155)}, false, 1.0});
  VisionCounts counts;
  EXPECT_TRUE(fitEdgeLines(features, {}, {}, counts).empty());
  EXPECT_EQ(counts.refused[static_cast<std::size_t>(Refusal::edgeFewFeatures)], 1);
}

TEST(EdgeLine, BordersOfACarpetAreSquareOnTheGround) {
  const CameraPose camera = cameraAt(16, 25, -12, 15);
  const HorizonFrame frame = horizonFrameOf(camera);
  const auto line = [&](Point2<Robot> a, Point2<Robot> b) {
    return lineThrough(*body::project(camera, {a.x, a.y, 0.0}),
                       *body::project(camera, {b.x, b.y, 0.0}), frame);
  };
  const EdgeLine far = line({-150, 200}, {-50, 230});
  const EdgeLine side = line({-150, 200}, {-120, 100});
  EXPECT_NEAR(groundCosine(far, side, frame), 0.0, 1e-6);
  EXPECT_NEAR(groundCosine(far, line({-150, 150}, {-50, 180}), frame), 1.0, 1e-6);
}

}  // namespace
}  // namespace kelpie::vision
