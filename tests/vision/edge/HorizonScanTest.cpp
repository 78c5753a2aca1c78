// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "robot/core/Random.h"
#include "tests/vision/Painting.h"
#include "vision/edge/HorizonScan.h"

namespace kelpie::vision {
namespace {

ScanLines linesAt(const CameraPose& camera) {
  return horizonScan(Lattice(horizonFrameOf(camera)), {});
}

TEST(HorizonScan, RunDownEveryFourthColumnOfALevelImage) {
  const ScanLines lines = linesAt(cameraAt(16, 0, -5));
  ASSERT_EQ(lines.size(), 51U);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    EXPECT_EQ(Sampler::pixelOf(lines[i].top.x), 4 + 4 * static_cast<int>(i));
    EXPECT_EQ(Sampler::pixelOf(lines[i].top.y) % 2, 0) << "on the lattice";
    EXPECT_NEAR(lines[i].down.dy, 1.0, 1e-9);
  }
}

TEST(HorizonScan, BeginJustAboveTheHorizonAndEndAtTheRim) {
  // 5 deg down: the horizon is in row 80 - 192 tan 5 deg = 63.2.
  const ScanLines lines = linesAt(cameraAt(16, 0, -5));
  EXPECT_NEAR(lines[26].top.y, 63.2 - 12.0, 2.1);
  EXPECT_FALSE(lines[26].cutTop);
  EXPECT_NEAR(lines[25].at(lines[25].steps - 1).y, 156.5, 2.1);
  const ScanLines down = linesAt(cameraAt(16, 0, -45));
  ASSERT_EQ(down.size(), 25U) << "every second one";
  EXPECT_NEAR(down[12].top.y, 4.5, 0.1);
  EXPECT_TRUE(down[12].cutTop);
}

TEST(HorizonScan, AreThinnedOutFarBelowTheHorizon) {
  const ScanLines lines = linesAt(cameraAt(16, 0, 0));
  const auto last = [&](std::size_t i) { return lines[i].at(lines[i].steps - 1).y; };
  // Horizon in row 80: nothing is 96 px below it.
  EXPECT_NEAR(last(20), last(21), 0.1);
  const ScanLines high = linesAt(cameraAt(16, 0, -15));
  EXPECT_GT(std::fabs(high[20].at(high[20].steps - 1).y - high[21].at(high[21].steps - 1).y), 10.0);
}

TEST(HorizonScan, LeanWithTheImageAndStaySquareToTheHorizon) {
  const CameraPose camera = cameraAt(16, 20, -10, 40);
  const BodyState body = bodyOf(camera);
  const double slope = (body.horizon.atRight - body.horizon.atLeft) / kImageWidth;
  for (const ScanLine& line : linesAt(camera)) {
    EXPECT_NEAR(line.down.dx + slope * line.down.dy, 0.0, 1e-9);
    EXPECT_GT(line.down.dy, 0.0);
  }
}

TEST(HorizonScan, ThereAreNoneWhenTheFieldCannotBeSeen) {
  EXPECT_TRUE(linesAt(cameraAt(16, 0, 60)).empty());
}

TEST(HorizonScan, AnUprightHorizonGivesLevelLines) {
  const ScanLines lines = linesAt(cameraAt(16, 0, -5, 90));
  EXPECT_GT(lines.size(), 30U);
  for (const ScanLine& line : lines) EXPECT_NEAR(std::fabs(line.down.dx), 1.0, 1e-9);
}

double offGrid(double way) {
  return std::fabs(way / kLatticeStep - std::round(way / kLatticeStep));
}

TEST(HorizonScan, EverySecondStepIsASampleOfTheLatticeHoweverTheImageIsRolled) {
  for (const double roll : {-70.0, -33.0, -8.0, 0.0, 5.0, 41.0}) {
    const Lattice lattice(horizonFrameOf(cameraAt(16, 10, -15, roll)));
    const ScanLines lines = horizonScan(lattice, {});
    ASSERT_GT(lines.size(), 20U);
    for (const ScanLine& line : lines)
      for (const int step : {0, 2, (line.steps - 1) & ~1}) {
        const LevelPoint at = lattice.frame().fromImage(line.at(step));
        EXPECT_LT(offGrid(at.u - lattice.u(0)), 1e-6) << roll;
        EXPECT_LT(offGrid(at.v - lattice.v(0)), 1e-6) << roll;
      }
  }
}

// Peer-2005 section 1.3: integer overflow for upright horizons.
TEST(HorizonScan, StayInTheUsableImageForAnyCamera) {
  Random random(3);
  for (int i = 0; i < 3000; ++i) {
    const double tilt = i % 3 == 0 ? 90.0 * (random.index(5) - 2.0) : random.uniform(-180, 180);
    const double roll = i % 5 == 0 ? 90.0 * (random.index(5) - 2.0) : random.uniform(-180, 180);
    for (const ScanLine& line : linesAt(cameraAt(16, 0, tilt, roll))) {
      ASSERT_GE(line.steps, 1);
      ASSERT_LE(line.steps, 263);
      for (const int step : {0, line.steps / 2, line.steps - 1})
        ASSERT_TRUE(Sampler::usable(line.at(step))) << tilt << " " << roll;
    }
  }
}

TEST(HorizonScan, AxesThatAreNotFiniteDoNoHarm) {
  CameraPose camera = cameraAt(16, 0, -5);
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(),
                           std::numeric_limits<double>::infinity(), 1e300, 0.0}) {
    camera.axes[6] = camera.axes[7] = camera.axes[8] = bad;
    for (const ScanLine& line : linesAt(camera)) {
      ASSERT_TRUE(Sampler::usable(line.at(0)));
      ASSERT_TRUE(Sampler::usable(line.at(line.steps - 1)));
    }
  }
}

}  // namespace
}  // namespace kelpie::vision
