// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/vision/Painting.h"
#include "vision/pixels/HorizonFrame.h"

namespace kelpie::vision {
namespace {

constexpr PixelPoint kMiddle{body::kNominalLens.principalX, body::kNominalLens.principalY};

TEST(HorizonFrame, UpIsTowardsTheHorizonWhateverTheRoll) {
  const ImageDirection level = horizonFrameOf(cameraAt(16, 30, -20)).up();
  EXPECT_NEAR(level.dx, 0, 1e-9);
  EXPECT_NEAR(level.dy, -1, 1e-9);
  const CameraPose rolled = cameraAt(16, 0, -20, 30);
  const ImageDirection up = horizonFrameOf(rolled).up();
  const BodyState body = bodyOf(rolled);
  const double alongHorizon =
      up.dx * kImageWidth + up.dy * (body.horizon.atRight - body.horizon.atLeft);
  EXPECT_NEAR(alongHorizon, 0, 1e-6);
}

TEST(HorizonFrame, PointsOnTheHorizonAreNotAboveIt) {
  for (const double roll : {0.0, 40.0, -25.0}) {
    const CameraPose camera = cameraAt(16, 10, -12, roll);
    const HorizonFrame frame = horizonFrameOf(camera);
    const Horizon horizon = bodyOf(camera).horizon;
    EXPECT_NEAR(frame.above({0.0, horizon.atLeft}), 0.0, 1e-6) << roll;
    EXPECT_NEAR(frame.above({kImageWidth, horizon.atRight}), 0.0, 1e-6) << roll;
    EXPECT_NEAR(frame.above(kMiddle),
                -body::kNominalLens.focalLength * std::tan(12 * 3.14159265 / 180), 1e-4)
        << roll;
  }
}

TEST(HorizonFrame, AStepBesideIsOneAlongAndOneAboveTheHorizon) {
  const HorizonFrame frame = horizonFrameOf(cameraAt(16, 0, -5, 35));
  const PixelPoint from{60.0, 90.0};
  const PixelPoint to = frame.beside(from, 7.0, 3.0);
  EXPECT_NEAR(frame.along(to) - frame.along(from), 7.0, 1e-9);
  EXPECT_NEAR(frame.above(to) - frame.above(from), 3.0, 1e-9);
  EXPECT_NEAR(frame.fromImage(to).u - frame.fromImage(from).u, 7.0, 1e-9);
  EXPECT_NEAR(frame.fromImage(to).v - frame.fromImage(from).v, -3.0, 1e-9);
  const PixelPoint again = frame.toImage(frame.fromImage(to));
  EXPECT_NEAR(again.x, to.x, 1e-9);
  EXPECT_NEAR(again.y, to.y, 1e-9);
}

TEST(HorizonFrame, IsNotRolledWhereTheImageHasNoUp) {
  CameraPose camera = cameraAt(16, 0, 0);
  camera.axes = {1, 0, 0, 0, 1, 0, 0, 0, -1};  // straight down
  const HorizonFrame down = horizonFrameOf(camera);
  EXPECT_EQ(down.cos, 1.0);
  EXPECT_EQ(down.sin, 0.0);
  EXPECT_EQ(down.above(kMiddle), -1e4);
  camera.axes[6] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(horizonFrameOf(camera).cos, 1.0);
}

}  // namespace
}  // namespace kelpie::vision
