// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cstdio>
#include <fstream>
#include <memory>
#include <sstream>

#include "robot/core/Random.h"
#include "tests/vision/Painting.h"
#include "vision/colour/ColourBuilder.h"
#include "vision/colour/ColourTable.h"
#include "vision/colour/TableFile.h"

namespace kelpie::vision {
namespace {

const std::string kReal2005 = KELPIE_SOURCE_DIR "/../shared/data/colour/nnmc_2005.bin";
const std::string kLabelled = KELPIE_SOURCE_DIR "/../shared/data/colour/labelled_samples.csv";

std::string temporary(const char* name) { return std::string(KELPIE_PICTURES "/") + name; }

void write(const std::string& path, const Bytes& bytes) {
  std::ofstream out(path, std::ios::binary);
  out.write(reinterpret_cast<const char*>(bytes.data()),
            static_cast<std::streamsize>(bytes.size()));
}

std::unique_ptr<ColourTable> nominal() {
  return std::make_unique<ColourTable>(buildColourTable(nominalPrototypes()));
}

std::uint8_t byteOf(double v) { return static_cast<std::uint8_t>(std::min(255.0, v + 0.5)); }

// Share of pixels of one paint, brightness +-25 % and noise sd 3, that get the class; the camera
// changes each channel by gain and offset.
double rightly(const ColourTable& table, Paint paint, ColourClass c, double gain, double offset) {
  Random random(3);
  int right = 0;
  for (int i = 0; i < 2000; ++i) {
    const double shade = random.uniform(0.75, 1.25);
    const auto value = [&](double v) {
      return byteOf(128.0 + gain * (v - 128.0) + offset + random.gaussian(0.0, 3.0));
    };
    const Yuv pixel{value(paint.y * shade), value(paint.cr), value(paint.cb)};
    right += table(pixel) == c ? 1 : 0;
  }
  return right / 2000.0;
}

constexpr std::array<std::pair<Paint, ColourClass>, 6> kPaints{{{kOrangePaint, ColourClass::orange},
                                                                {kBluePaint, ColourClass::blue},
                                                                {kYellowPaint, ColourClass::yellow},
                                                                {kPinkPaint, ColourClass::pink},
                                                                {kGreenPaint, ColourClass::green},
                                                                {kWhitePaint, ColourClass::white}}};

TEST(ColourTable, NominalPaintsInShadeAndNoiseAreRecognised) {
  const auto table = nominal();
  for (const auto& [paint, c] : kPaints) EXPECT_GT(rightly(*table, paint, c, 1.0, 0.0), 0.98);
}

TEST(ColourTable, CameraGainOfTenPercentIsTolerated) {
  const auto table = nominal();
  for (const auto& [paint, c] : kPaints) {
    EXPECT_GT(rightly(*table, paint, c, 0.9, 0.0), 0.95) << kColourNames[index(c)];
    EXPECT_GT(rightly(*table, paint, c, 1.1, 0.0), 0.95) << kColourNames[index(c)];
  }
}

TEST(ColourTable, CameraOffsetOfEightGreyLevelsLeavesMostPixelsRight) {
  const auto table = nominal();
  for (const auto& [paint, c] : kPaints) {
    EXPECT_GT(rightly(*table, paint, c, 1.0, -8.0), 0.65) << kColourNames[index(c)];
    EXPECT_GT(rightly(*table, paint, c, 1.0, 8.0), 0.65) << kColourNames[index(c)];
  }
}

TEST(ColourTable, ColoursFarFromEveryPrototypeAreNone) {
  const auto table = nominal();
  EXPECT_EQ((*table)({200, 60, 200}), ColourClass::none);
  EXPECT_EQ((*table)({60, 220, 220}), ColourClass::none);
}

TEST(ColourTable, NeighbouringCellsAreKeptApart) {
  auto table = std::make_unique<ColourTable>();
  table->set(6, ColourClass::black);
  table->set(7, ColourClass::pink);
  table->set(6, ColourClass::orange);
  EXPECT_EQ(table->at(5), ColourClass::none);
  EXPECT_EQ(table->at(6), ColourClass::orange);
  EXPECT_EQ(table->at(7), ColourClass::pink);
}

TEST(ColourTable, SavedTableIsReadBackTheSame) {
  const auto table = nominal();
  const std::string path = temporary("table.kt");
  ASSERT_TRUE(saveColourTable(*table, path, "test"));
  auto back = loadColourTable(path);
  ASSERT_TRUE(back) << back.error();
  EXPECT_EQ(back->cells, table->cells);
}

TEST(ColourTable, WrongSizeIsOneLineWithTheFileAndBothSizes) {
  const std::string path = temporary("short.bin");
  write(path, Bytes(1234));
  auto table = loadColourTable(path);
  ASSERT_FALSE(table);
  EXPECT_EQ(table.error(),
            path + ": 1234 bytes, expected 2097152 (128^3) or a Kelpie colour table");
}

TEST(ColourTable, DamagedFileIsRefused) {
  const std::string path = temporary("damaged.kt");
  ASSERT_TRUE(saveColourTable(*nominal(), path, "test"));
  auto bytes = readBytes(path);
  (*bytes)[5000] ^= 1U;
  write(path, *bytes);
  EXPECT_EQ(loadColourTable(path).error(), path + ": checksum differs");
  bytes->resize(3000);
  write(path, *bytes);
  EXPECT_NE(loadColourTable(path).error().find("cut off"), std::string::npos);
}

TEST(ColourTable, MissingFileIsOneLine) {
  EXPECT_EQ(loadColourTable("no/such.bin").error(), "no/such.bin: cannot be opened");
}

TEST(ColourTable, MajorityOfTheSixteenFineCellsDecidesAndMaybeCountsAsTheClass) {
  Bytes fine(std::size_t{1} << 21, 127);
  for (std::size_t y = 0; y < 4; ++y) {  // the first coarse cell: 4 x 2 x 2 fine ones
    fine[y * 16384] = fine[y * 16384 + 1] = fine[y * 16384 + 128] = 0x10 | 3;
  }
  const std::string path = temporary("fine.bin");
  write(path, fine);
  auto table = loadColourTable(path);
  ASSERT_TRUE(table) << table.error();
  EXPECT_EQ(table->at(0), ColourClass::yellow);
  EXPECT_EQ(table->at(1), ColourClass::none);
}

// What README.md says about the size chosen: 89 % of the labelled pixels keep their fine class.
TEST(ColourTable, Reduced2005TableAgreesWithTheFineOneOnLabelledPixels) {
  auto table = loadColourTable(kReal2005);
  if (!table) GTEST_SKIP() << "without ../shared/data/colour";
  auto fine = readBytes(kReal2005);
  std::ifstream in(kLabelled);
  std::string line;
  std::getline(in, line);
  int same = 0;
  int all = 0;
  std::array<int, 128> ours{1, 2, 0, 3, 4, 5, 6, 7, 8, 9, 10};
  while (std::getline(in, line)) {
    std::istringstream row(line);
    unsigned y = 0, cr = 0, cb = 0;
    char comma = 0;
    row >> y >> comma >> cr >> comma >> cb;
    const auto b = [](unsigned v) { return static_cast<std::uint8_t>(v); };
    const std::uint8_t id = (*fine)[(y / 2) * 16384 + (cr / 2) * 128 + cb / 2];
    same += static_cast<int>((*table)({b(y), b(cr), b(cb)})) == ours[id] ? 1 : 0;
    ++all;
  }
  EXPECT_EQ(all, 2616);
  EXPECT_GT(same, 0.88 * all);
}

}  // namespace
}  // namespace kelpie::vision
