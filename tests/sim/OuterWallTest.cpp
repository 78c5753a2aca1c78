// SPDX-License-Identifier: Apache-2.0
// The outer wall of the 2004 challenge and its sheets: what hangs there, and what the camera sees.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "robot/body/Camera.h"
#include "tools/sim/world/World.h"

namespace kelpie::sim {
namespace {

body::FieldDescription field() { return *body::fieldDescription("2006"); }

TEST(OuterWall, SheetsObeyTheRulesForEverySeed) {
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    const OuterWall wall = outerWall(field(), 8.0, seed);
    EXPECT_GE(wall.sheets.size(), 6U);
    EXPECT_GE(pinkPlaces(wall).size(), 3U);
    for (const WallSheet& sheet : wall.sheets) {
      EXPECT_GE(sheet.width, 10.0);
      EXPECT_LE(sheet.width, 50.0);
      EXPECT_LE(sheet.high, wall.height);
      for (const Paper& paper : sheet.papers) {
        EXPECT_GE(std::min(paper.right - paper.left, paper.high - paper.low), 10.0 - 1e-9);
        EXPECT_GE(paper.left, 0.0);
        EXPECT_LE(paper.right, sheet.width + 1e-9);
      }
    }
  }
}

TEST(OuterWall, SheetsDoNotTouch) {
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    const OuterWall wall = outerWall(field(), 8.0, seed);
    for (const WallSheet& a : wall.sheets)
      for (const WallSheet& b : wall.sheets)
        if (&a != &b && a.side == b.side) {
          const double gap = a.at < b.at ? b.at - a.at - a.width : a.at - b.at - b.width;
          EXPECT_GT(gap, 0.0) << seed;
        }
  }
}

TEST(OuterWall, IsTheSameForTheSameSeedOnly) {
  const auto first = pinkPlaces(outerWall(field(), 8.0, 5));
  EXPECT_EQ(first[0].x, pinkPlaces(outerWall(field(), 8.0, 5))[0].x);
  EXPECT_NE(first[0].x, pinkPlaces(outerWall(field(), 8.0, 6))[0].x);
}

// The pixel at which a robot in the middle of the field, looking level at `place`, sees its height.
Yuv seenAt(const Scene& scene, Point2<Field> place, double height) {
  const Pose2 pose{{180.0, 270.0}, Angle::rad(std::atan2(place.y - 270.0, place.x - 180.0))};
  const CameraPose camera = body::cameraPose({}, {10.0, Angle::deg(0), {}});
  ColumnCameras columns;
  columns.fill(fieldCamera(pose, camera));
  Random random(1);
  const auto image = std::make_unique<Image>();
  Camera(idealCamera(), {}).render(scene, columns, random, *image);
  const Point2<Robot> there = robotFromField(pose, place);
  const auto pixel = body::project(camera, {there.x, there.y, height});
  return image->pixel(static_cast<int>(pixel->x), static_cast<int>(pixel->y));
}

OuterWall wallWithOneSheet() {
  OuterWall wall = outerWall(field(), 0.0, 1);
  WallSheet sheet;
  sheet.side = 1;  // x = 395, from y = -45 up
  sheet.at = 305.0;
  sheet.width = 30.0;
  sheet.high = 28.0;
  sheet.papers.push_back({15.0, 29.0, 10.0, 24.0, colours::kPink, true});
  wall.sheets = {sheet};
  return wall;
}

TEST(OuterWall, CameraSeesPaperOnSheetOnWall) {
  Scene scene = fieldScene(field(), 0);
  addWall(scene, wallWithOneSheet());
  EXPECT_NEAR(seenAt(scene, {395.0, 282.0}, 17.0).cr, colours::kPink.cr, 3.0);
  EXPECT_NEAR(seenAt(scene, {395.0, 266.0}, 17.0).y, colours::kWhite.y, 3.0);
  EXPECT_NEAR(seenAt(scene, {395.0, 240.0}, 17.0).cr, colours::kWall.cr, 3.0);
  EXPECT_LT(seenAt(scene, {395.0, 240.0}, 17.0).y, colours::kWhite.y - 20.0F);
}

TEST(OuterWall, HiddenLandmarksLeaveWhiteGoalsAndNoBeacons) {
  Scene scene = fieldScene(field(), 0);
  EXPECT_GT(seenAt(scene, {180.0, 570.0}, 15.0).cb, 150);
  hideLandmarks(scene);
  EXPECT_TRUE(scene.beacons.empty());
  EXPECT_NEAR(seenAt(scene, {180.0, 570.0}, 15.0).cb, colours::kWhite.cb, 3.0);
}

TEST(OuterWall, StopsRobotsAndABeaconTakenAwayDoesNot) {
  World world(WorldParams{}, field(), *scenario("empty-goal", field(), {{TeamColour::red, 1}}, 3),
              3);
  ASSERT_TRUE(world.putUp(wallWithOneSheet()));
  ASSERT_TRUE(world.carry(0, {{390.0, 270.0}, Angle::deg(90)}));
  world.tick();
  EXPECT_LT(world.truth(world.time()).robots[0].pose.position.x, 388.5);
  const Pose2 atBeacon{{375.0, 138.0}, Angle::deg(90)};
  ASSERT_TRUE(world.carry(0, atBeacon));
  world.tick();
  EXPECT_GT(distance(world.truth(world.time()).robots[0].pose.position, atBeacon.position), 1.0);
  ASSERT_TRUE(world.takeLandmarksAway());
  ASSERT_TRUE(world.carry(0, atBeacon));
  world.tick();
  EXPECT_LT(distance(world.truth(world.time()).robots[0].pose.position, atBeacon.position), 1.0);
}

TEST(OuterWall, ASecondOneHasNoRoomInThePhysicalWorld) {
  WorldParams params;
  params.fast = false;
  World world(params, field(), *scenario("empty-goal", field(), {{TeamColour::red, 1}}, 3), 3);
  ASSERT_TRUE(world.putUp(wallWithOneSheet()));
  const Status refused = world.putUp(wallWithOneSheet());
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.error().find("no room"), std::string::npos);
}

}  // namespace
}  // namespace kelpie::sim
