// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <memory>

#include "robot/core/Random.h"
#include "tests/vision/Painting.h"
#include "vision/Vision.h"
#include "vision/pixels/PlaneImage.h"

namespace kelpie::vision {
namespace {

TEST(PlaneImage, NominalTableWithoutRingCorrectionGivesBackEveryPlane) {
  const auto calibration = loadCalibration("nominal", "none");
  ASSERT_TRUE(calibration);
  Random random(4);
  const auto plane = std::make_unique<ClassPlane>();
  for (auto& number : *plane) number = static_cast<std::uint8_t>(random.index(kColourClassCount));
  const auto image = std::make_unique<Image>();
  imageOf(*plane, *image);
  const auto again = std::make_unique<ClassPlane>();
  classifyWhole(*image, *calibration, *again);
  EXPECT_EQ(*again, *plane);
}

TEST(PlaneImage, VisionFindsTheSameThingsInIt) {
  Painting p;
  p.carpetEnd = 230;
  p.noise = 3.0;
  p.balls.push_back({20, 100});
  p.beacons.push_back({{-60, 200}, kBluePaint, kPinkPaint});
  const CameraPose camera = cameraAt(16, 0, -5);
  const auto input = std::make_unique<FrameInput>();
  paint(p, camera, input->image);
  const auto state = stateForPaintings();
  const Percepts seen = step({*input, bodyOf(camera)}, {}, *state);
  const auto plane = std::make_unique<ClassPlane>();
  classifyWhole(input->image, state->tables, *plane);
  imageOf(*plane, input->image);
  const auto planeState = std::make_unique<VisionState>(*loadCalibration("nominal", "none"));
  const Percepts made = step({*input, bodyOf(camera)}, {}, *planeState);
  ASSERT_TRUE(seen.ball.present && made.ball.present);
  EXPECT_NEAR(made.ball.distance, seen.ball.distance, 0.06 * seen.ball.distance);
  EXPECT_NEAR(made.ball.heading.deg(), seen.ball.heading.deg(), 0.3);
  EXPECT_NE(find(made, LandmarkKind::beaconBlueOnPink), nullptr);
}

}  // namespace
}  // namespace kelpie::vision
