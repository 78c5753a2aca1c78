// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "tools/calibrate/SharedData.h"
#include "tools/calibrate/distance/SizeFit.h"

namespace kelpie::calibrate {
namespace {

TEST(SizeFit, MeasuredSizesOf2005Tell201And5Pixels) {
  const auto fit = fitSizes(sharedData() + "distance/");
  if (!fit) GTEST_SKIP() << fit.error();
  EXPECT_NEAR(fit->focalLength, 201.5, 0.25);
  EXPECT_LT(fit->focalSd, 4.0);
  EXPECT_GT((fit->focalLength - 192.0) / fit->focalSd, 2.0);
}

TEST(SizeFit, AFolderWithoutMeasurementsIsRefusedWithItsFile) {
  const auto fit = fitSizes(KELPIE_OUT "/nothing/");
  ASSERT_FALSE(fit.ok());
  EXPECT_NE(fit.error().find("nothing/ball_radius.csv"), std::string::npos) << fit.error();
}

}  // namespace
}  // namespace kelpie::calibrate
