// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "vision/colour/RingTable.h"

namespace kelpie::vision {
namespace {

std::unique_ptr<RingTable> published() {
  return std::make_unique<RingTable>(buildRingTable(ringModel2006()));
}

// A pixel at the same distance from all three centres.
RingPlace alike(std::size_t distance) {
  const auto d = static_cast<std::uint8_t>(distance);
  return {d, d, d};
}

// Checklist E3, recomputed there from the printed coefficients.
TEST(RingModel, PublishedPolynomialGivesTheValuesOfChecklistE3) {
  const RingModel m = ringModel2006();
  EXPECT_NEAR(ringDistort(m.channel[0], 200, 131) - 200, -86.47, 0.01);
  EXPECT_NEAR(ringDistort(m.channel[0], 128, 50) - 128, -12.15, 0.01);
  EXPECT_NEAR(ringDistort(m.channel[1], 50, 100) - 50, 22.45, 0.01);
  EXPECT_NEAR(ringDistort(m.channel[2], 128, 131) - 128, 21.66, 0.01);
}

TEST(RingModel, InverseUndoesTheModelEverywhere) {
  for (const RingChannel& c : ringModel2006().channel) {
    for (double d = 0; d <= 132; d += 1) {
      for (double v = 0; v < 256; v += 5) {
        EXPECT_NEAR(ringCorrect(c, ringDistort(c, v, d), d), v, 1e-9);
      }
    }
  }
}

TEST(RingTable, UndoesTheDistortionToOneGreyLevelInTheMiddle) {
  const auto table = published();
  const RingModel m = ringModel2006();
  for (std::size_t d = 0; d < 60; ++d) {
    for (double v = 40; v < 215; v += 1) {
      const auto raw = [&](std::size_t channel) {
        const double far = ringDistort(m.channel[channel], v, static_cast<double>(d));
        return static_cast<std::uint8_t>(std::lround(far));
      };
      const Yuv c = (*table)({raw(0), raw(1), raw(2)}, alike(d));
      EXPECT_NEAR(c.y, v, 1.0);
      EXPECT_NEAR(c.cr, v, 1.0);
      EXPECT_NEAR(c.cb, v, 1.0);
    }
  }
}

TEST(RingTable, ValuesTheMiddleCannotShowAreClamped) {
  const auto table = published();
  const Yuv bright = (*table)({250, 250, 250}, alike(131));
  EXPECT_EQ(bright.y, 255);
  EXPECT_EQ(bright.cr, 255);
  const Yuv dark = (*table)({0, 0, 0}, alike(131));
  EXPECT_EQ(dark.cr, 0);
  EXPECT_EQ(dark.cb, 0);
}

// Checklist: of 34,048 entries Y is clamped 482 times low and 5909 times high.
TEST(RingTable, AsManyEntriesSaturateAsTheChecklistCounts) {
  const RingChannel c = ringModel2006().channel[0];
  int low = 0;
  int high = 0;
  for (int d = 0; d < 133; ++d) {
    for (int v = 0; v < 256; ++v) {
      const double x = ringCorrect(c, v, d);
      low += x < -0.5 ? 1 : 0;
      high += x >= 255.5 ? 1 : 0;
    }
  }
  EXPECT_EQ(low, 482);
  EXPECT_EQ(high, 5909);
}

TEST(RingTable, NoneChangesNothing) {
  const auto table = std::make_unique<Expected<RingTable>>(loadRingTable("none"));
  for (int v = 0; v < 256; ++v) {
    const auto b = static_cast<std::uint8_t>(v);
    EXPECT_EQ((**table)({b, b, b}, alike(132)).cr, b);
  }
}

TEST(RingTable, SavedTableIsReadBackTheSame) {
  const std::string path = KELPIE_PICTURES "/ring.kt";
  const auto table = published();
  ASSERT_TRUE(saveRingTable(*table, path, "2006 polynomial"));
  auto back = loadRingTable(path);
  ASSERT_TRUE(back) << back.error();
  EXPECT_EQ(back->y, table->y);
  EXPECT_EQ(back->cb, table->cb);
}

TEST(RingTable, CentresAreKeptInTheFile) {
  auto table = published();
  table->centre = {{{110, 80}, {105, 77}, {97, 84}}};
  const std::string path = KELPIE_PICTURES "/centres.kt";
  ASSERT_TRUE(saveRingTable(*table, path, "test"));
  auto back = loadRingTable(path);
  ASSERT_TRUE(back) << back.error();
  EXPECT_EQ(back->centre[0].column, 110);
  EXPECT_EQ(back->centre[1].row, 77);
  EXPECT_EQ(back->centre[2].column, 97);
}

TEST(RingTable, CentreFarFromTheImagesIsRefused) {
  auto table = published();
  table->centre[1].column = 140;
  const std::string path = KELPIE_PICTURES "/far.kt";
  ASSERT_TRUE(saveRingTable(*table, path, "test"));
  EXPECT_EQ(loadRingTable(path).error(), path + ": a ring centre far from the image's");
}

// What the middle shows as 150 the base robot shows as 0.9 * 150 + 5 = 140.
TEST(RingTable, ShiftToTheBaseRobotIsFoldedIn) {
  const RobotShift shift{{{0.9, 5.0}, {}, {}}};
  const auto table = std::make_unique<RingTable>(buildRingTable(ringModel2006(), shift));
  EXPECT_EQ((*table)({150, 150, 150}, {}).y, 140);
  EXPECT_EQ((*table)({150, 150, 150}, {}).cr, 150);
  const RingChannel y = ringModel2006().channel[0];
  const auto far = static_cast<std::uint8_t>(std::lround(ringDistort(y, 150, 100)));
  EXPECT_NEAR((*table)({far, 0, 0}, alike(100)).y, 140, 1);
}

TEST(RingTable, ShiftOfAFinishedTableDiffersByOneLevelAtMost) {
  const RobotShift shift{{{1.1, -7.3}, {0.93, 8.8}, {1.02, -2.5}}};
  const auto once = std::make_unique<RingTable>(buildRingTable(ringModel2006(), shift));
  const auto twice = std::make_unique<RingTable>(shifted(*published(), shift));
  const auto plain = published();
  for (std::size_t i = 0; i < once->y.size(); ++i) {
    if (plain->y[i] == 0 || plain->y[i] == 255) continue;  // clamped before the shift
    ASSERT_NEAR(once->y[i], twice->y[i], 1);
  }
}

// Facts-2005 section 3.
TEST(RingTable, NominalCentresAreThoseOfTheCorrectionOf2005) {
  const auto table = std::make_unique<Expected<RingTable>>(loadRingTable("nominal"));
  EXPECT_EQ((*table)->centre[0].column, 110);
  EXPECT_EQ((*table)->centre[1].column, 105);
  EXPECT_EQ((*table)->centre[2].column, 97);
  EXPECT_EQ((*table)->y, published()->y);
  EXPECT_EQ((*table)->cb, published()->cb);
}

TEST(RingTable, UnknownSourceIsOneLineThatNamesTheChoices) {
  EXPECT_EQ(loadRingTable("2007").error(),
            "2007: cannot be opened (ring correction: \"nominal\", \"none\", \"2006\" or a file)");
}

TEST(RingDistances, AreThoseOfPixelCentresToTheImageCentre) {
  const RingDistances d;
  for (int y = 0; y < kImageHeight; y += 7) {
    for (int x = 0; x < kImageWidth; ++x) {
      EXPECT_EQ(static_cast<long>(d(x, y, {}).cr), std::lround(std::hypot(x - 103.5, y - 79.5)));
    }
  }
}

TEST(RingDistances, CountFromEachChannelsOwnCentre) {
  const RingDistances d;
  const std::array<RingCentre, 3> centre{{{110, 80}, {116, 92}, {92, 68}}};
  for (int y = 0; y < kImageHeight; y += 3) {
    for (int x = 0; x < kImageWidth; x += 3) {
      const RingPlace at = d(x, y, centre);
      const auto from = [&](RingCentre c) {
        return std::lround(std::hypot(x + 0.5 - c.column, y + 0.5 - c.row));
      };
      ASSERT_EQ(static_cast<long>(at.y), from(centre[0]));
      ASSERT_EQ(static_cast<long>(at.cr), from(centre[1]));
      ASSERT_EQ(static_cast<long>(at.cb), from(centre[2]));
    }
  }
}

}  // namespace
}  // namespace kelpie::vision
