// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "robot/core/Random.h"
#include "tools/calibrate/Csv.h"
#include "tools/calibrate/SharedData.h"
#include "tools/calibrate/colour/Shift.h"

namespace kelpie::calibrate {
namespace {

std::string written(const char* name, const std::string& text) {
  const std::string path = std::string(KELPIE_OUT "/") + name;
  std::ofstream(path) << text;
  return path;
}

constexpr const char* kHeader =
    "date,dog,mac_low4,base_dog,paper,y_dog,y_base_mean,u_dog,u_base_mean,v_dog,v_base_mean\n";

TEST(Shift, NoiseOfTheRobotsPixelsDoesNotFlattenTheLine) {
  Random random(2);
  std::vector<ShiftPair> pairs;
  for (const double base : {60.0, 90.0, 110.0, 140.0})
    for (int i = 0; i < 2000; ++i) {
      const double robot = (base + 4.0) / 0.95 + random.gaussian(0.0, 6.0);
      const auto byte = static_cast<std::uint8_t>(robot + 0.5);
      pairs.push_back({{byte, byte, byte}, {base, base, base}});
    }
  const auto shift = fitShift(pairs);
  ASSERT_TRUE(shift) << shift.error();
  EXPECT_NEAR((*shift)[0].gain, 0.95, 0.006);
  EXPECT_NEAR((*shift)[0].offset, -4.0, 0.7);
}

TEST(Shift, PapersOfOneColourAreRefused) {
  const std::vector<ShiftPair> pairs(10, {{100, 100, 100}, {98, 98, 98}});
  EXPECT_EQ(fitShift(pairs).error(), "the papers' colours do not differ enough");
}

TEST(Shift, ReproducesTheFitsOf2005) {
  const auto rows = fitShifts(sharedData() + "camera/linear_shift_samples.csv");
  if (!rows) GTEST_SKIP() << "without ../shared/data/camera: " << rows.error();
  std::size_t at = 0;
  const auto same =
      forEachRow(sharedData() + "camera/linear_shift_refit.csv",
                 "date,dog,mac_low4,n,My,Cy,Mu,Cu,Mv,Cv", [&](const Cells& cells) -> Status {
                   const ShiftRow& row = rows->at(at++);
                   EXPECT_EQ(row.mac, cells[2]);
                   for (std::size_t c = 0; c < 3; ++c) {
                     double gain = 0.0, offset = 0.0;
                     EXPECT_TRUE(parseNumber(cells[4 + 2 * c], gain));
                     EXPECT_TRUE(parseNumber(cells[5 + 2 * c], offset));
                     EXPECT_NEAR(row.shift[c].gain, gain, 0.00006) << row.dog;
                     EXPECT_NEAR(row.shift[c].offset, offset, 0.00006) << row.dog;
                   }
                   return Done{};
                 });
  EXPECT_TRUE(same) << same.error();
  EXPECT_EQ(at, 16U);
}

TEST(Shift, MissingFileIsOneLine) {
  EXPECT_EQ(fitShifts("no/such.csv").error(), "no/such.csv: cannot be opened");
}

TEST(Shift, WrongColumnsNameFileAndLine) {
  const auto header = written("header.csv", "a,b,c\n");
  EXPECT_EQ(fitShifts(header).error().find(header + ":1: the header must be date"), 0U);
  const auto cut = written("short.csv", std::string(kHeader) + "d,r1,c0,b1,red,1,2,3\n");
  EXPECT_EQ(fitShifts(cut).error(), cut + ":2: expected 11 columns");
  const auto word = written("word.csv", std::string(kHeader) + "d,r1,c0,b1,red,x,2,3,4,5,6\n");
  EXPECT_EQ(fitShifts(word).error(), word + ":2: expected a byte and a number for each channel");
}

}  // namespace
}  // namespace kelpie::calibrate
