// SPDX-License-Identifier: Apache-2.0
// The posts and the gaps of painted goals, through the whole of vision. What is painted
// before a goal is a plain white wall: no robot's legs, no shadow.
#include <gtest/gtest.h>

#include <cmath>
#include <utility>

#include "tests/vision/Painting.h"
#include "vision/goal/GoalFinder.h"

namespace kelpie::vision {
namespace {

constexpr double kDegrees = 180.0 / 3.14159265358979;

double bearingOf(double x, double y) { return std::atan2(-x, y) * kDegrees; }

struct Place {
  double x, y;
};

// A goal whose mouth is seen `turned` degrees from its front, its middle straight ahead.
struct Turned {
  Painting painting;
  Place left;
  Place right;

  Turned(double distance, double turned, Paint colour) {
    const double c = std::cos(turned / kDegrees);
    const double s = std::sin(turned / kDegrees);
    const auto at = [&](double along, double in) {
      return Point2<Robot>{along * c - in * s, distance + along * s + in * c};
    };
    for (const auto& [from, to] :
         {std::pair(at(-40, 0), at(-40, 30)), std::pair(at(-40, 30), at(40, 30)),
          std::pair(at(40, 30), at(40, 0))})
      painting.walls.push_back({from, to, 0.0, 30.0, colour});
    painting.carpetEnd = distance + 80.0;
    left = {at(-40, 0).x, at(-40, 0).y};
    right = {at(40, 0).x, at(40, 0).y};
  }
};

TEST(GoalShape, PostsOfAGoalSeenAslantAreThoseOfItsMouth) {
  for (const double turned : {-40.0, -20.0, 0.0, 20.0, 40.0}) {
    for (const double distance : {180.0, 260.0}) {
      Turned goal(distance, turned, kYellowPaint);
      goal.painting.noise = 3.0;
      const Seen seen = look(goal.painting, cameraAt(16, 0, -4));
      const auto* found = find(seen.percepts, LandmarkKind::goalYellow);
      ASSERT_NE(found, nullptr) << turned << " " << distance;
      EXPECT_NEAR(found->leftEdge.deg(), bearingOf(goal.left.x, goal.left.y), 1.5)
          << turned << " " << distance;
      EXPECT_NEAR(found->rightEdge.deg(), bearingOf(goal.right.x, goal.right.y), 1.5)
          << turned << " " << distance;
    }
  }
}

TEST(GoalShape, PostsAreTheSameWithTheHeadRolled) {
  for (const double roll : {-40.0, -20.0, 20.0, 40.0}) {
    const Turned goal(220, 30, kBluePaint);
    const Seen seen = look(goal.painting, cameraAt(16, 0, -4, roll));
    const auto* found = find(seen.percepts, LandmarkKind::goalBlue);
    ASSERT_NE(found, nullptr) << roll;
    EXPECT_NEAR(found->leftEdge.deg(), bearingOf(goal.left.x, goal.left.y), 1.5) << roll;
    EXPECT_NEAR(found->rightEdge.deg(), bearingOf(goal.right.x, goal.right.y), 1.5) << roll;
  }
}

TEST(GoalGaps, GoalWithoutARobotIsOneGapFromPostToPost) {
  for (const double y : {180.0, 250.0, 350.0}) {
    Painting p;
    p.carpetEnd = y + 30.0;
    p.noise = 3.0;
    addGoal(p, 10, y, kBluePaint);
    const Seen seen = look(p, cameraAt(16, 0, -4));
    ASSERT_EQ(seen.percepts.gaps.size(), 1U) << y;
    const GoalGap& gap = seen.percepts.gaps[0];
    EXPECT_EQ(gap.goal, LandmarkKind::goalBlue);
    EXPECT_NEAR(gap.left.deg(), bearingOf(-30, y), 1.5) << y;
    EXPECT_NEAR(gap.right.deg(), bearingOf(50, y), 1.5) << y;
    EXPECT_FALSE(gap.leftCut || gap.rightCut);
  }
}

// Where the sight past x, y (a wall before the goal) crosses the mouth's line, seen from the robot.
double pastAt(const CameraPose& camera, double x, double y, double mouth) {
  const double share = (mouth - camera.position.y) / (y - camera.position.y);
  return bearingOf(camera.position.x + share * (x - camera.position.x), mouth);
}

// 16 cm wide, 20 high: a goalie.
TEST(GoalGaps, WhiteWallBeforeTheGoalLeavesTwoGaps) {
  const CameraPose camera = cameraAt(16, 0, -4);
  for (const double middle : {-12.0, 0.0, 15.0}) {
    Painting p;
    p.carpetEnd = 280.0;
    p.noise = 3.0;
    addGoal(p, 0, 250, kYellowPaint);
    p.walls.push_back({{middle - 8, 235}, {middle + 8, 235}, 0, 20, kWhitePaint});
    const Seen seen = look(p, camera);
    ASSERT_EQ(seen.percepts.gaps.size(), 2U) << middle;
    const auto& gaps = seen.percepts.gaps;
    EXPECT_NEAR(gaps[0].left.deg(), bearingOf(-40, 250), 1.5) << middle;
    EXPECT_NEAR(gaps[0].right.deg(), pastAt(camera, middle - 8, 235, 250), 1.5) << middle;
    EXPECT_NEAR(gaps[1].left.deg(), pastAt(camera, middle + 8, 235, 250), 1.5) << middle;
    EXPECT_NEAR(gaps[1].right.deg(), bearingOf(40, 250), 1.5) << middle;
  }
}

TEST(GoalGaps, BallBeforeTheGoalIsNoObstacle) {
  Painting p;
  p.carpetEnd = 230.0;
  addGoal(p, 0, 200, kBluePaint);
  p.balls.push_back({0, 190});
  EXPECT_EQ(look(p, cameraAt(16, 0, -4)).percepts.gaps.size(), 1U);
}

TEST(GoalGaps, GapThatTheImageEndsIsMarkedAsCut) {
  Painting p;
  p.carpetEnd = 150.0;
  addGoal(p, 60, 120, kBluePaint);
  const Seen seen = look(p, cameraAt(16, 0, -5));
  ASSERT_EQ(seen.percepts.gaps.size(), 1U);
  EXPECT_TRUE(seen.percepts.gaps[0].rightCut);
  EXPECT_FALSE(seen.percepts.gaps[0].leftCut);
}

}  // namespace
}  // namespace kelpie::vision
