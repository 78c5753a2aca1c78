// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include "robot/core/fields/Encoding.h"
#include "tests/vision/Painting.h"
#include "vision/Vision.h"
#include "vision/colour/ColourBuilder.h"
#include "vision/light/LightFollower.h"

namespace kelpie::vision {
namespace {

Paint lit(Paint p, double light, double colour) {
  return {light * p.y, 128.0 + light * colour * (p.cr - 128.0),
          128.0 + light * colour * (p.cb - 128.0)};
}

// A line, and a beacon behind it, in light of which so much is there.
Painting place(double light, double colour = 1.0) {
  Painting p;
  p.carpetEnd = 150;
  p.lineAt = 60;
  p.carpet = lit(kGreenPaint, light, colour);
  p.beacons.push_back({{0, 150}, lit(kPinkPaint, light, colour), lit(kBluePaint, light, colour)});
  p.noise = 3.0;
  return p;
}

struct Robot {
  std::unique_ptr<VisionState> state = stateForPaintings();
  VisionParams params;
  std::unique_ptr<FrameInput> input = std::make_unique<FrameInput>();

  Percepts look(const Painting& painting, int images) {
    const CameraPose camera = cameraAt(18, 0, -4);
    paint(painting, camera, input->image);
    Percepts seen;
    for (int i = 0; i < images; ++i) {
      seen = step({*input, bodyOf(camera)}, params, *state);
      input->light = seen.light;
    }
    return seen;
  }
  LightGains light() const { return input->light.applied; }
};

std::vector<std::uint8_t> encoded(const Percepts& seen) {
  std::vector<std::uint8_t> bytes;
  encode(seen, bytes);
  return bytes;
}

bool seesBeacon(const Percepts& seen) {
  return find(seen, LandmarkKind::beaconPinkOnBlue) != nullptr;
}

TEST(Light, ABeaconInLightOfHalfTheColourIsSeenAfterASecond) {
  Robot robot;
  const Painting dark = place(0.55, 0.8);
  EXPECT_FALSE(seesBeacon(robot.look(dark, 1)));
  EXPECT_TRUE(seesBeacon(robot.look(dark, 30)));
}

TEST(Light, ThatIsNotToBeFollowedLeavesTheTableAsItIs) {
  Robot robot;
  robot.params.light.follow = false;
  EXPECT_FALSE(seesBeacon(robot.look(place(0.55, 0.8), 31)));
  EXPECT_EQ(robot.light().brightness, 1.0);
}

TEST(Light, IsEstimatedWithinATenthOfWhatItIs) {
  for (const double light : {0.55, 0.75, 1.0, 1.35}) {
    Robot robot;
    robot.look(place(light), 100);
    EXPECT_NEAR(robot.light().colour, light, 0.1) << light;
  }
}

TEST(Light, ThatGoesOutAndOnAgainIsFollowedBothWays) {
  Robot robot;
  robot.look(place(1.0), 30);
  EXPECT_TRUE(seesBeacon(robot.look(place(0.6), 200)));
  EXPECT_TRUE(seesBeacon(robot.look(place(1.0), 200)));
}

// Landmarks that a window or a lamp shines on, while the carpet lies in even light.
Painting overexposed() {
  Painting p = place(1.0);
  for (PaintedBeacon& beacon : p.beacons)
    for (Paint* paint : {&beacon.upper, &beacon.lower})
      *paint = {2.0 * paint->y, 64.0 + 0.5 * paint->cr, 64.0 + 0.5 * paint->cb};
  return p;
}

TEST(Glare, OfABeaconIsSeenThroughAfterTwoSecondsWithoutOne) {
  Robot robot;
  EXPECT_FALSE(seesBeacon(robot.look(overexposed(), 1)));
  EXPECT_TRUE(seesBeacon(robot.look(overexposed(), 70)));
  EXPECT_TRUE(robot.input->light.glare);
}

TEST(Glare, ThatIsOverIsForgotten) {
  Robot robot;
  robot.look(overexposed(), 70);
  EXPECT_TRUE(seesBeacon(robot.look(place(1.0), 70)));
  EXPECT_FALSE(robot.input->light.glare);
}

TEST(Glare, IsNotLookedForWhileABeaconIsSeen) {
  Robot robot;
  robot.look(place(1.0), 100);
  EXPECT_FALSE(robot.input->light.glare);
  EXPECT_EQ(robot.input->light.missing, 0);
}

TEST(Glare, LeavesAColourInEvenLightInItsClass) {
  const ColourTable even = buildColourTable(nominalPrototypes());
  const ColourTable glare = withGlare(even);
  for (const Prototype& p : nominalPrototypes()) {
    const Yuv c{static_cast<std::uint8_t>(p.y), static_cast<std::uint8_t>(p.cr),
                static_cast<std::uint8_t>(p.cb)};
    EXPECT_EQ(glare(c), even(c));
  }
}

TEST(Light, OfAnImageWithoutCarpetTellsNothing) {
  Robot robot;
  Painting wall;
  wall.carpet = kWallPaint;
  robot.look(wall, 50);
  EXPECT_EQ(robot.light().brightness, 1.0);
  EXPECT_EQ(robot.light().colour, 1.0);
}

// An owner's table brings its own; the built-in one's must not drift from what it is built of.
TEST(Light, ItsSurfacesHaveTheColoursThatTheNominalTableIsBuiltOf) {
  const LightParams light;
  const std::vector<std::pair<ColourClass, SurfaceColour>> surfaces{
      {ColourClass::green, light.carpet},
      {ColourClass::white, light.line},
      {ColourClass::blue, light.blue},
      {ColourClass::yellow, light.yellow},
      {ColourClass::pink, light.pink}};
  for (const auto& [colour, surface] : surfaces)
    for (const Prototype& p : nominalPrototypes())
      if (p.colour == colour) {
        EXPECT_EQ(surface.y, p.y);
        EXPECT_EQ(surface.cr, p.cr);
        EXPECT_EQ(surface.cb, p.cb);
      }
}

// A log that keeps one image in some is replayed from what was believed before each of them.
TEST(Light, IsAllThatAnImageSaysOfTheOnesBefore) {
  Robot robot;
  for (int image = 0; image < 60; ++image) {
    const FrameInput before = *robot.input;
    const Percepts seen = robot.look(place(0.55, 0.8), 1);
    Robot late;
    late.input->light = before.light;
    EXPECT_EQ(encoded(late.look(place(0.55, 0.8), 1)), encoded(seen)) << image;
  }
}

TEST(Light, ADarkCarpetBesideWhiteLinesIsNoDarkLight) {
  CameraLight light;
  LightSightings seen{};
  seen[0] = {true, std::log(0.7), std::log(0.7)};
  for (int i = 0; i < 300; ++i) remember(seen, {}, light);
  EXPECT_LT(estimatedLight(light, {}).brightness, 0.8);
  seen[1] = {true, 0.0, 0.0};  // lines that are white are in this light
  for (int i = 0; i < 300; ++i) remember(seen, {}, light);
  EXPECT_NEAR(estimatedLight(light, {}).brightness, 1.0, 0.1);
}

TEST(Light, StaysWithinItsBounds) {
  CameraLight light;
  LightSightings seen{};
  for (LightSighting& one : seen) one = {true, -5.0, -5.0};
  for (int i = 0; i < 300; ++i) remember(seen, {}, light);
  EXPECT_EQ(estimatedLight(light, {}).brightness, LightParams{}.least);
  EXPECT_EQ(estimatedLight(light, {}).colour, LightParams{}.least);
}

TEST(Light, ThatIsDimmerMakesTheRingTableBrighterWithinSixtyImages) {
  const auto tables = std::make_unique<PixelTables>(nominalCalibration());
  CameraLight light;
  for (int i = 0; i < 60; ++i) {
    const double left = std::log(0.6 / light.applied.brightness);
    const LightSighting one{true, left, left};
    if (isWhole(light)) learnLight({{one, one, one}}, {}, light);
    light = advanced(light);
    tables->follow(light);
  }
  EXPECT_NEAR(tables->ring({60, 140, 120}, {}).y, 100, 5);
  tables->follow({});
  EXPECT_EQ(tables->ring.cells, std::make_unique<PixelTables>(nominalCalibration())->ring.cells);
}

}  // namespace
}  // namespace kelpie::vision
