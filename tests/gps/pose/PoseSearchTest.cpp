// SPDX-License-Identifier: Apache-2.0
// The search over a grid of poses: what it tries, what it keeps, and how many frames it takes.
#include <gtest/gtest.h>

#include "gps/SamePose.h"
#include "gps/pose/PoseSearch.h"
#include "robot/core/Random.h"

namespace kelpie::gps {
namespace {

constexpr double kApart = 30.0;

bool same(const Pose2& a, const Pose2& b) { return samePose(a, b, kApart, kApart); }

// Scores by the distance to one pose, and refines half of the way to it.
struct HillScene {
  Pose2 top;
  std::optional<FoundPose> tried(const Pose2& start) const {
    if (start.position.x < 100.0) return std::nullopt;
    return FoundPose{start, -distance(start.position, top.position)};
  }
  FoundPose refined(const FoundPose& found) const {
    const Point2<Field> way = top.position - found.pose.position;
    const Pose2 pose{found.pose.position + way * 0.5, found.pose.heading};
    return {pose, -0.5 * way.norm()};
  }
  bool same(const Pose2& a, const Pose2& b) const { return kelpie::gps::same(a, b); }
};

TEST(PoseSearch, TheGridCoversItsPartOfTheField) {
  const PoseGrid grid{360.0, 270.0, 4, 3, 12};
  ASSERT_EQ(grid.size(), 144U);
  EXPECT_EQ(grid.at(0).position.x, 45.0);
  EXPECT_EQ(grid.at(0).position.y, 45.0);
  EXPECT_EQ(grid.at(1).position.x, 45.0);
  EXPECT_NEAR(grid.at(1).heading.deg(), 30.0, 1e-9);
  EXPECT_EQ(grid.at(143).position.x, 315.0);
  EXPECT_EQ(grid.at(143).position.y, 225.0);
}

TEST(PoseSearch, KeepsTheBestOfDistinctPlacesInOrder) {
  Random random(5);
  FoundPoses found;
  for (int i = 0; i < 2000; ++i) {
    const Pose2 pose{{random.uniform(0, 360), random.uniform(0, 540)},
                     Angle::rad(random.uniform(-maths::kPi, maths::kPi))};
    keepDistinct({pose, random.uniform(0.0, 1.0)}, 8, same, found);
    ASSERT_LE(found.size(), 8U);
    for (std::size_t a = 0; a < found.size(); ++a)
      for (std::size_t b = a + 1; b < found.size(); ++b) {
        ASSERT_GE(found[a].score, found[b].score);
        ASSERT_FALSE(same(found[a].pose, found[b].pose));
      }
  }
  EXPECT_EQ(found.size(), 8U);
  EXPECT_GT(found[7].score, 0.9);
}

TEST(PoseSearch, ABetterPoseTakesThePlaceOfAllThatItIsOneWith) {
  FoundPoses found;
  keepDistinct({{{100, 100}, Angle()}, 1.0}, 8, same, found);
  keepDistinct({{{140, 100}, Angle()}, 2.0}, 8, same, found);
  ASSERT_EQ(found.size(), 2U);
  keepDistinct({{{120, 100}, Angle()}, 1.5}, 8, same, found);  // worse than one of them
  ASSERT_EQ(found.size(), 2U);
  keepDistinct({{{120, 100}, Angle()}, 3.0}, 8, same, found);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].score, 3.0);
}

TEST(PoseSearch, IsSpreadOverFramesAndEndsAtTheBest) {
  const HillScene scene{{{250.0, 400.0}, Angle()}};
  const PoseGrid grid{360.0, 540.0, 18, 27, 1};
  PoseSearch search;
  int frames = 1;
  while (!stepPoseSearch(grid, {20, 2, 5}, scene, search)) {
    EXPECT_TRUE(search.running);
    ASSERT_LT(++frames, 100);
  }
  EXPECT_EQ(frames, 25 + 3 + 1);  // 486 tried, 5 refined, once more put in order
  EXPECT_FALSE(search.running);
  ASSERT_FALSE(search.found.empty());
  EXPECT_LT(distance(search.found[0].pose.position, scene.top.position), 10.0);
}

TEST(PoseSearch, FindsNothingWhereNothingCanBe) {
  const HillScene scene{{{250.0, 400.0}, Angle()}};
  PoseSearch search;
  int frames = 1;
  while (!stepPoseSearch({90.0, 540.0, 3, 9, 4}, {20, 2, 5}, scene, search) && frames < 100)
    ++frames;
  EXPECT_LT(frames, 100);
  EXPECT_TRUE(search.found.empty());
}

}  // namespace
}  // namespace kelpie::gps
