// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "tests/calibrate/SheetMaker.h"
#include "tools/calibrate/ring/RingJudge.h"

namespace kelpie::calibrate {
namespace {

using vision::buildRingTable;
using vision::ringModel2006;

TEST(RingJudge, TheTrueTableMakesSheetsEvenAndNoneLeavesThemUneven) {
  const auto verdict =
      compareUnevenness(sheetsOf(allPapers(), ringModel2006()), buildRingTable(ringModel2006()));
  for (std::size_t c = 0; c < 3; ++c) {
    EXPECT_LT(verdict.learnt[c], 0.35);
    EXPECT_EQ(verdict.learnt[c], verdict.published[c]);
    EXPECT_GT(verdict.none[c], 2.0);
    EXPECT_FALSE(isWorse(verdict, c));
  }
}

TEST(RingJudge, ATableForAnotherCameraIsWorseThanNone) {
  const auto verdict =
      compareUnevenness(sheetsOf(allPapers(), {}), buildRingTable(ringModel2006()));
  for (std::size_t c = 0; c < 3; ++c) {
    EXPECT_LT(verdict.none[c], 0.2);
    EXPECT_TRUE(isWorse(verdict, c));
  }
}

// A step of 10 levels between the inner and the outer half of the rings: rms 5.
TEST(RingJudge, UnevennessIsTheRmsOfTheRings) {
  Sheet sheet{"step", {}};
  for (int ring = 0; ring < 4; ++ring)
    for (int i = 0; i < 100; ++i) {
      const auto value = static_cast<std::uint8_t>(ring < 2 ? 90 : 100);
      sheet.pixels.push_back({vision::kMiddleColumn + 12 * ring, 80, {value, 128, 128}});
    }
  const auto levels = unevenness({sheet}, buildRingTable({}));
  EXPECT_NEAR(levels[0], 5.0, 1e-9);
  EXPECT_NEAR(levels[1], 0.0, 1e-9);
}

}  // namespace
}  // namespace kelpie::calibrate
