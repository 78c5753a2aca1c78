// SPDX-License-Identifier: Apache-2.0
// What of a venue may differ: tape, carpet, light, room; and how a robot's camera and uniform look.
#include <gtest/gtest.h>

#include <memory>

#include "tools/sim/bodies/Randomisation.h"
#include "tools/sim/camera/Camera.h"

namespace kelpie::sim {
namespace {

const body::FieldDescription kField = *body::fieldDescription("2006");

double widthOf(const Quad& line) {
  return maths::hypot(line.corner[3].x - line.corner[0].x, line.corner[3].y - line.corner[0].y);
}

FieldPoint3 middleOf(const Quad& quad) {
  return {0.5 * (quad.corner[0].x + quad.corner[2].x), 0.5 * (quad.corner[0].y + quad.corner[2].y),
          0.0};
}

TEST(Venue, WiderTapeKeepsItsMiddle) {
  Venue venue;
  venue.tapeWidth = 5.0;
  const Scene like = fieldScene(kField, 0);
  const Scene wide = fieldScene(kField, 0, venue);
  ASSERT_EQ(like.lines.size(), wide.lines.size());
  for (std::size_t i = 0; i < like.lines.size(); ++i) {
    EXPECT_NEAR(widthOf(like.lines[i]), 2.5, 1e-9);
    EXPECT_NEAR(widthOf(wide.lines[i]), 5.0, 1e-9);
    EXPECT_NEAR(middleOf(like.lines[i]).x, middleOf(wide.lines[i]).x, 1e-9);
    EXPECT_NEAR(middleOf(like.lines[i]).y, middleOf(wide.lines[i]).y, 1e-9);
  }
  EXPECT_NEAR(like.circle[0].radius + like.circle[1].radius,
              wide.circle[0].radius + wide.circle[1].radius, 1e-9);
}

TEST(Venue, AnotherRoomStandsOutsideAndLeavesGoalsAndBeacons) {
  const Scene like = fieldScene(kField, 0);
  for (std::uint64_t seed = 1; seed < 30; ++seed) {
    Venue venue;
    venue.room = seed;
    const Scene other = fieldScene(kField, 0, venue);
    EXPECT_EQ(other.beacons.size(), like.beacons.size());
    ASSERT_EQ(other.goals, like.goals);
    for (std::size_t i = other.goals; i < other.fixtures.size(); ++i)
      for (const Quad& quad : other.fixtures[i].quads)
        for (const FieldPoint3& corner : quad.corner)
          EXPECT_TRUE(corner.x < -60 || corner.x > 420 || corner.y < -60 || corner.y > 600);
  }
}

// Looks straight down at a place from 30 cm.
ColumnCameras over(Point2<Field> place) {
  ColumnCameras columns;
  columns.fill({{place.x, place.y, 30.0}, {1, 0, 0}, {0, -1, 0}, {0, 0, -1}, {}});
  return columns;
}

Yuv seenAt(const Scene& scene, Point2<Field> place, const CameraParams& params) {
  Random random(1);
  const auto image = std::make_unique<Image>();
  Camera(params, {}).render(scene, over(place), random, *image);
  return image->pixel(104, 80);
}

CameraParams clean() {
  CameraParams params = idealCamera();
  params.light = true;
  return params;
}

Scene litFrom(double deg) {
  Venue venue;
  venue.light = {Angle::deg(deg), 0.2, 10.0};
  return fieldScene(kField, 0, venue);
}

TEST(Venue, TheSecondLightIsBrighterAndWarmerAtItsSide) {
  const Scene scene = litFrom(90.0);
  const Yuv near = seenAt(scene, {60, 500}, clean());
  const Yuv far = seenAt(scene, {60, 40}, clean());
  EXPECT_GT(near.y, far.y + 15);
  EXPECT_GT(near.cr, far.cr + 2);
  EXPECT_LT(near.cb, far.cb - 2);
  const Yuv ideal = seenAt(scene, {60, 500}, idealCamera());
  EXPECT_NEAR(ideal.y, colours::kGreen.y, 1);
}

TEST(Venue, StripesOfTheCarpetAlternate) {
  Venue venue;
  venue.stripes = {50.0, 0.1};
  const Scene scene = fieldScene(kField, 0, venue);
  const Yuv even = seenAt(scene, {30, 150}, clean());
  const Yuv odd = seenAt(scene, {75, 150}, clean());
  EXPECT_NEAR(odd.y - even.y, 0.2 * static_cast<double>(colours::kGreen.y), 2);
}

TEST(Venue, ADarkCarpetIsDarkAndItsLinesAreNot) {
  Venue venue;
  venue.carpet = 0.7;
  const Scene scene = fieldScene(kField, 0, venue);
  EXPECT_NEAR(seenAt(scene, {60, 150}, clean()).y, 0.7 * static_cast<double>(colours::kGreen.y), 1);
  EXPECT_NEAR(seenAt(scene, {180, 270}, clean()).y, colours::kWhite.y, 2);
}

TEST(Tone, CurvesWhatLiesBetweenTheEnds) {
  RobotCamera robot;
  robot.tone = {0.9, 1.0, 1.1};
  Scene scene;
  scene.ceiling = {100, 60, 200};
  Random random(1);
  const auto image = std::make_unique<Image>();
  ColumnCameras up;
  up.fill({{0, 0, 30.0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {}});
  Camera(idealCamera(), robot).render(scene, up, random, *image);
  const Yuv seen = image->pixel(50, 50);
  EXPECT_NEAR(seen.y, 110, 1);  // 255 (100 / 255)^0.9
  EXPECT_EQ(seen.cr, 60);
  EXPECT_NEAR(seen.cb, 196, 1);  // 128 + 127 (72 / 127)^1.1
}

TEST(Uniform, AFadedOneIsNearerToGreyAndAWornOneHasScuffs) {
  Scene fresh = fieldScene(kField, 0);
  Scene worn = fieldScene(kField, 0);
  RobotLook look{{{180, 270}, Angle()}, 10.0, TeamColour::red, 7};
  setRobots(fresh, {look});
  look.uniform = {0.4, 1.5, 0.0};
  setRobots(worn, {look});
  const auto reddest = [](const Scene& scene) {
    float max = 0.0F;
    for (const Quad& quad : scene.robots[0].quads)
      if (quad.depthBias == 2.0) max = std::max(max, quad.colour.cr);
    return max;
  };
  EXPECT_NEAR(static_cast<double>(reddest(fresh)), 165.0, 0.1);
  EXPECT_NEAR(static_cast<double>(reddest(worn)), 151.0, 0.1);
  const auto scuffs = [](const Scene& scene) {
    int count = 0;
    for (const Quad& quad : scene.robots[0].quads) count += quad.depthBias == 2.6 ? 1 : 0;
    return count;
  };
  EXPECT_EQ(scuffs(fresh), 0);
  EXPECT_GT(scuffs(worn), 2);
}

}  // namespace
}  // namespace kelpie::sim
