// SPDX-License-Identifier: Apache-2.0
// The pinhole geometry against sizes measured on real robots (2005). Those distances start at the
// neck, the camera looked about 9 cm ahead of it. The team fitted its constants to these very data.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <sstream>
#include <vector>

#include "robot/body/Camera.h"

namespace kelpie::vision {
namespace {

constexpr double kCameraAhead = 9.0;

struct Measured {
  double pixels;
  double distance;
};

// Columns 1 and 2 of a file, rows marked as excluded left out.
std::vector<Measured> measured(const char* name) {
  std::ifstream in(std::string(KELPIE_SOURCE_DIR "/../shared/data/distance/") + name);
  std::vector<Measured> rows;
  std::string line;
  std::getline(in, line);
  while (std::getline(in, line)) {
    std::istringstream row(line);
    std::string cell[4];
    for (auto& c : cell) std::getline(row, c, ',');
    if (cell[3] != "1") rows.push_back({std::stod(cell[1]), std::stod(cell[2])});
  }
  return rows;
}

template <class F>
double rmsPercent(const std::vector<Measured>& rows, F model) {
  double sum = 0.0;
  for (const Measured& m : rows) {
    const double error = model(m.pixels) / m.distance - 1.0;
    sum += error * error;
  }
  return 100.0 * std::sqrt(sum / static_cast<double>(rows.size()));
}

TEST(DistanceData, BeaconOfFortyCentimetresFitsTheMeasuredHeights) {
  const auto rows = measured("beacon_height_lab.csv");
  if (rows.empty()) GTEST_SKIP() << "without ../shared/data/distance";
  const double rms =
      rmsPercent(rows, [](double h) { return body::kFocalLength * 40.0 / h + 5.0 + kCameraAhead; });
  EXPECT_LT(rms, 5.0);  // the team's own fit of two constants: 3.8
}

TEST(DistanceData, GoalsBackWallNotItsMouthFitsTheMeasuredHeights) {
  const auto rows = measured("goal_height.csv");
  if (rows.empty()) GTEST_SKIP() << "without ../shared/data/distance";
  const auto distance = [](double h) { return body::kFocalLength * 30.0 / h + kCameraAhead; };
  const double mouth = rmsPercent(rows, distance);
  const double back = rmsPercent(rows, [&](double h) { return distance(h) - 30.0; });
  EXPECT_LT(back, 8.0);  // the team's own fit of two constants: 10.8
  EXPECT_GT(mouth, 15.0);
}

// Its authors' circle lay half a pixel outside the ball: 1103.9 / (r + 0.85) is their fit.
TEST(DistanceData, BallOfRadius42FitsTheMeasuredRadiiLessHalfAPixel) {
  const auto rows = measured("ball_radius.csv");
  if (rows.empty()) GTEST_SKIP() << "without ../shared/data/distance";
  std::vector<Measured> fromTwentyCm;
  for (const auto& m : rows) {
    if (m.distance >= 20.0) fromTwentyCm.push_back(m);
  }
  const double rms = rmsPercent(
      fromTwentyCm, [](double r) { return body::kFocalLength * 4.2 / (r - 0.5) + kCameraAhead; });
  EXPECT_LT(rms, 7.0);
}

}  // namespace
}  // namespace kelpie::vision
