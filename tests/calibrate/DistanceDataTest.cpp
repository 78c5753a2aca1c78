// SPDX-License-Identifier: Apache-2.0
// The geometry of vision's distances against sizes measured on real robots (2005). The team fitted
// its two constants an object to these very data. `kelpie evaluate distances` prints the figures.
#include <gtest/gtest.h>

#include "tools/calibrate/distance/DistanceData.h"

namespace kelpie::calibrate {
namespace {

class DistanceData : public ::testing::Test {
 protected:
  void SetUp() override {
    for (const auto object : {SizedObject::ball, SizedObject::beacon, SizedObject::goal})
      if (!readMeasurements(object)) GTEST_SKIP() << readMeasurements(object).error();
  }
  static Measurements from(SizedObject object, double min) {
    Measurements kept;
    const auto rows = readMeasurements(object);
    for (const auto& m : *rows)
      if (m.distance >= min) kept.push_back(m);
    return kept;
  }
  static double percent(SizedObject object, double min, const Optics& optics) {
    return misfit(from(object, min), geometry(object, optics)).rmsPercent;
  }
  static double cm(SizedObject object, double min, const Optics& optics) {
    return misfit(from(object, min), geometry(object, optics)).rms;
  }
  static double teamsCm(SizedObject object, double min) {
    return misfit(from(object, min), teamsFit(object)).rms;
  }
};

TEST_F(DistanceData, BeaconOfFortyCentimetresFitsTheMeasuredHeights) {
  EXPECT_LT(percent(SizedObject::beacon, 0, {}), 5.0);  // the team's own fit: 3.8
}

TEST_F(DistanceData, GoalsBackWallNotItsMouthFitsTheMeasuredHeights) {
  EXPECT_LT(percent(SizedObject::goal, 0, {}), 8.0);  // the team's own fit: 10.8
  Measurements mouth = from(SizedObject::goal, 0);
  for (auto& m : mouth) m.ahead += 30.0;
  EXPECT_GT(misfit(mouth, geometry(SizedObject::goal, {})).rmsPercent, 15.0);
}

TEST_F(DistanceData, BallOfRadius42FitsTheMeasuredRadiiLessHalfAPixel) {
  EXPECT_LT(percent(SizedObject::ball, 20, {192.0, 0.5, 0.0}), 7.0);
}

// The same beacon at the same place gives the same height: 7850 px cm from 120 cm on, but 5850 to
// 7670 nearer. What was measured at 80 and 100 cm was not a whole beacon.
TEST_F(DistanceData, OneFocalLengthFitsBeaconsFrom120CmOnAndNoneFitsThoseNearer) {
  for (const auto& m : from(SizedObject::beacon, 0)) {
    const double focalLength = m.pixels * (m.distance - m.ahead - 5.0) / 40.0;
    if (m.distance >= 120.0) {
      EXPECT_NEAR(focalLength, 196.0, 8.0) << m.distance;
    } else {
      EXPECT_LT(focalLength, 192.0) << m.distance;
    }
  }
}

// All three ask for 5 % more than the 192 px of the field of view, as of a lens that enlarges the
// middle. The edges: the tools of 2005 lost mixed pixels at both ends of a beacon or goal and drew
// the ball's circle outside it.
TEST_F(DistanceData, FocalLengthOf201FitsNoWorseThanTheTeamsConstants) {
  EXPECT_LT(cm(SizedObject::ball, 0, {201.5, 1.39, 3.17}), teamsCm(SizedObject::ball, 0));
  EXPECT_LT(cm(SizedObject::goal, 0, {201.5, -1.38, 0.0}), teamsCm(SizedObject::goal, 0));
  EXPECT_LT(cm(SizedObject::beacon, 120, {201.5, -0.85, 0.0}), teamsCm(SizedObject::beacon, 120));
}

}  // namespace
}  // namespace kelpie::calibrate
