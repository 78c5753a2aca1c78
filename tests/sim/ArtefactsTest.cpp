// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <memory>

#include "tools/sim/camera/Artefacts.h"
#include "vision/colour/RingTable.h"

namespace kelpie::sim {
namespace {

ArtefactParams only(bool ring, bool noise) {
  ArtefactParams params;
  params.ring = ring;
  params.noise = noise;
  params.blur = params.shift = false;
  return params;
}

std::unique_ptr<Image> sheetOf(const ArtefactParams& params, const RobotCamera& robot,
                               std::array<float, 3> colour = {200, 128, 128}) {
  RawColumn raw;
  raw.y.fill(colour[0]);
  raw.cr.fill(colour[1]);
  raw.cb.fill(colour[2]);
  auto image = std::make_unique<Image>();
  Random random(5);
  Artefacts artefacts(params, robot);
  for (std::size_t x = 0; x < kImageWidth; ++x) artefacts.add(x, raw, random, *image);
  return image;
}

std::unique_ptr<Image> sheet(const ArtefactParams& params, std::array<float, 3> colour,
                             const ColourShift& shift = {}) {
  return sheetOf(params, {shift, kMiddleCentres}, colour);
}

// Checklist E3: white (200, 128, 128) becomes (113, 121, 150) in the corner, d = 131.
TEST(Artefacts, WhiteInTheCornerIsAsTheTableSays) {
  EXPECT_NEAR(ringValue(0, 200, 131) - 200, -86.47, 0.01);
  EXPECT_NEAR(ringValue(1, 128, 131) - 128, -6.88, 0.01);
  EXPECT_NEAR(ringValue(2, 128, 131) - 128, 21.66, 0.01);
  EXPECT_NEAR(ringValue(2, 50, 100) - 50, 34.66, 0.01);
  EXPECT_NEAR(ringValue(1, 200, 50) - 200, -5.62, 0.01);
  const auto image = sheet(only(true, false), {200, 128, 128});
  EXPECT_NEAR(image->pixel(0, 0).y, 114, 1);  // the pixel's centre is at d = 130.5
  EXPECT_NEAR(image->pixel(207, 159).cr, 121, 1);
  EXPECT_NEAR(image->pixel(207, 0).cb, 149, 1);
  EXPECT_EQ(image->pixel(104, 80).y, 200);
}

TEST(Artefacts, CoefficientsAreThePublishedOnes) {
  std::ifstream file(KELPIE_SOURCE_DIR "/../shared/data/camera/ring2006_polynomial.csv");
  if (!file) GTEST_SKIP() << "no ../shared/data/camera/ring2006_polynomial.csv here";
  std::string line;
  std::getline(file, line);
  for (std::size_t c = 0; c < 3; ++c) {
    std::array<double, 6> k{};
    file >> line;
    ASSERT_EQ(std::sscanf(line.c_str() + 2, "%lf,%lf,%lf,%lf,%lf,%lf", &k[0], &k[1], &k[2], &k[3],
                          &k[4], &k[5]),
              6);
    for (const double d : {0.0, 40.0, 90.0, 131.0}) {
      const double expected =
          (k[0] * 99 + k[1]) * d * d * d + (k[2] * 99 + k[3]) * d * d + (k[4] * 99 + k[5]) * d + 99;
      EXPECT_NEAR(ringValue(c, 99, d), expected, 1e-9);
    }
  }
}

RobotCamera offCentre() {
  RobotCamera robot;
  robot.centres = {PixelPoint{116.0, 70.0}, {104.0, 92.0}, {95.0, 80.0}};
  return robot;
}

TEST(Artefacts, EachChannelHasItsRingAboutItsOwnCentre) {
  const RobotCamera robot = offCentre();
  const auto image = sheetOf(only(true, false), robot);
  for (int py = 0; py < kImageHeight; py += 7)
    for (int px = 0; px < kImageWidth; px += 7) {
      const Yuv value = image->pixel(px, py);
      const std::array<int, 3> seen{value.y, value.cr, value.cb};
      for (std::size_t c = 0; c < 3; ++c) {
        const double d = std::hypot(px + 0.5 - robot.centres[c].x, py + 0.5 - robot.centres[c].y);
        EXPECT_NEAR(seen[c], ringValue(c, c == 0 ? 200 : 128, d), 0.51) << px << " " << py;
      }
    }
}

TEST(Artefacts, WithoutCentresEveryRingIsCentredOnTheImage) {
  ArtefactParams params = only(true, false);
  params.centres = false;
  const auto image = sheetOf(params, offCentre());
  const auto centred = sheetOf(params, {});
  EXPECT_TRUE(image->y == centred->y && image->cr == centred->cr && image->cb == centred->cb);
  EXPECT_EQ(image->pixel(0, 0).y, image->pixel(207, 159).y);
}

// facts-2005 section 3: optical centre columns Y 110, Cr 105, Cb 97.
TEST(Artefacts, RobotsHaveTheCentresOf2005OnAverageAndTheSpreadAskedFor) {
  constexpr int kRobots = 4000;
  constexpr std::array<double, 3> kColumns{110.0, 105.0, 97.0};
  Random random(9);
  std::array<double, 3> column{}, row{}, squares{};
  for (int i = 0; i < kRobots; ++i) {
    const RingCentres centres = randomCentres(random, 2.0);
    for (std::size_t c = 0; c < 3; ++c) {
      column[c] += centres[c].x / kRobots;
      row[c] += centres[c].y / kRobots;
      squares[c] += (centres[c].y - 80.0) * (centres[c].y - 80.0) / kRobots;
    }
  }
  for (std::size_t c = 0; c < 3; ++c) {
    EXPECT_NEAR(column[c], kColumns[c], 0.15);
    EXPECT_NEAR(row[c], 80.0, 0.15);
    EXPECT_NEAR(std::sqrt(squares[c]), 2.0, 0.1);
    EXPECT_EQ(randomCentres(random, 0.0)[c].x, kColumns[c]);
  }
}

TEST(Artefacts, NoCentreIsFartherOffThanARingTableCanCorrect) {
  Random random(10);
  for (int i = 0; i < 500; ++i)
    for (const PixelPoint centre : randomCentres(random, 6.0)) {
      EXPECT_LE(std::fabs(centre.x - kImageMiddle.x), vision::kMaxCentreOffset);
      EXPECT_LE(std::fabs(centre.y - kImageMiddle.y), vision::kMaxCentreOffset);
    }
}

TEST(Artefacts, ARobotsCameraComesFromItsSeed) {
  Random one(3), same(3), other(4);
  const RobotCamera camera = randomCamera(one, {});
  const RobotCamera again = randomCamera(same, {});
  EXPECT_EQ(camera.shift.gain, again.shift.gain);
  EXPECT_EQ(camera.centres[2].x, again.centres[2].x);
  EXPECT_NE(camera.centres[2].x, randomCamera(other, {}).centres[2].x);
}

TEST(Artefacts, NoiseHasItsSpread) {
  const auto image = sheet(only(false, true), {100, 128, 128});
  double sum = 0.0;
  double squares = 0.0;
  for (const std::uint8_t value : image->y) {
    sum += value;
    squares += value * value;
  }
  const double mean = sum / kImagePixels;
  EXPECT_NEAR(mean, 100.0, 0.1);
  EXPECT_NEAR(std::sqrt(squares / kImagePixels - mean * mean), 2.52, 0.1);  // rounding adds 1/12
}

TEST(Artefacts, ShiftStaysInTheMeasuredRange) {
  Random random(8);
  for (int i = 0; i < 200; ++i) {
    const ColourShift shift = randomShift(random);
    for (std::size_t c = 0; c < 3; ++c) {
      EXPECT_GE(shift.gain[c], 0.898);
      EXPECT_LE(shift.gain[c], 1.117);
      EXPECT_GE(shift.offset[c], -13.6);
      EXPECT_LE(shift.offset[c], 10.1);
    }
  }
}

TEST(Artefacts, ShiftIsALineInTheValue) {
  ArtefactParams params = only(false, false);
  params.shift = true;
  ColourShift shift;
  shift.gain = {1.05, 0.9, 1.0};
  shift.offset = {-5.0, 8.0, 3.0};
  const Yuv p = sheet(params, {100, 120, 140}, shift)->pixel(50, 50);
  EXPECT_EQ(p.y, 100);
  EXPECT_EQ(p.cr, 116);
  EXPECT_EQ(p.cb, 143);
}

}  // namespace
}  // namespace kelpie::sim
