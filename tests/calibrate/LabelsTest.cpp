// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "tests/calibrate/SheetMaker.h"
#include "tools/calibrate/Images.h"
#include "tools/calibrate/colour/Labels.h"

namespace kelpie::calibrate {
namespace {

using vision::ColourClass;

std::string inFolder(const char* name) { return std::string(KELPIE_OUT "/") + name; }

std::string written(const char* name, const std::string& text) {
  std::ofstream(inFolder(name), std::ios::binary) << text;
  return inFolder(name);
}

constexpr const char* kClasses =
    "the classes are none, orange, blue, yellow, pink, robotBlue, robotRed, green, grey, white, "
    "black or a number of 2005 (0 to 12, 127)";

TEST(Labels, CsvHasTheClassIdsOf2005) {
  const auto pixels =
      readLabelledCsv(written("labels.csv", "Y,Cr,Cb,class\n74,191,99,0\n30,126,130,5\n"));
  ASSERT_TRUE(pixels) << pixels.error();
  ASSERT_EQ(pixels->size(), 2U);
  EXPECT_EQ((*pixels)[0].colour, ColourClass::orange);
  EXPECT_EQ((*pixels)[1].colour, ColourClass::robotBlue);
  EXPECT_EQ((*pixels)[1].value.cb, 130);
}

TEST(Labels, CsvMayHaveNamesAndNumbersOfClasses) {
  const auto pixels = readLabelledCsv(
      written("names.csv", "Y,Cr,Cb,class\n74,191,99,orange\n30,126,130,5\n1,2,3,none\n9,9,9,127"));
  ASSERT_TRUE(pixels) << pixels.error();
  ASSERT_EQ(pixels->size(), 4U);
  EXPECT_EQ((*pixels)[0].colour, ColourClass::orange);
  EXPECT_EQ((*pixels)[1].colour, ColourClass::robotBlue);
  EXPECT_EQ((*pixels)[2].colour, ColourClass::none);
  EXPECT_EQ((*pixels)[3].colour, ColourClass::none);
}

TEST(Labels, UnknownClassesAreOneLineWithFileLineAndList) {
  for (const std::string name : {"purple", "13", "Orange", "200", ""}) {
    const auto file = written("purple.csv", "Y,Cr,Cb,class\n1,2,3,4\n1,2,3," + name + "\n");
    const std::string reported = readLabelledCsv(file).error();
    EXPECT_EQ(reported.find(file + ":3: no class '"), 0U) << reported;
    EXPECT_NE(reported.find(kClasses), std::string::npos) << reported;
  }
}

TEST(Labels, BadCsvIsOneLineWithFileAndLine) {
  const auto columns = written("columns.csv", "Y,Cr,Cb,class\n1,2,3\n");
  EXPECT_EQ(readLabelledCsv(columns).error(), columns + ":2: expected 4 columns");
  const auto large = written("large.csv", "Y,Cr,Cb,class\n1,2,3,4\n1,2,256,4\n");
  EXPECT_EQ(readLabelledCsv(large).error(),
            large + ":3: expected three numbers in 0..255 and a class");
  const auto none = written("none.csv", "Y,Cr,Cb,class\n");
  EXPECT_EQ(readLabelledCsv(none).error(), none + ": no labelled pixels");
}

TEST(Labels, BoxesInImagesGiveCorrectedPixels) {
  Random random(1);
  const auto image = sheetImage(kPapers[2], vision::ringModel2006(), random);
  ASSERT_TRUE(writePicture(image, inFolder("white.png")));
  const auto list = written("boxes.txt", "# a corner\nwhite.png 4 4 24 24 white\n");
  const auto pixels = readRegions(list, buildRingTable(vision::ringModel2006()));
  ASSERT_TRUE(pixels) << pixels.error();
  EXPECT_EQ(pixels->size(), 400U);
  double sum = 0.0;
  for (const auto& p : *pixels) sum += p.value.y / 400.0;
  EXPECT_NEAR(sum, kPapers[2].y, 4.0);  // 130 uncorrected
}

TEST(Labels, BoxesMayHaveNumbersOfClasses) {
  Random random(1);
  ASSERT_TRUE(writePicture(sheetImage(kPapers[2], {}, random), inFolder("paper.png")));
  const auto pixels =
      readRegions(written("numbers.txt", "paper.png 4 4 5 6 9\n"), vision::buildRingTable({}));
  ASSERT_TRUE(pixels) << pixels.error();
  ASSERT_EQ(pixels->size(), 2U);
  EXPECT_EQ((*pixels)[1].colour, ColourClass::white);
}

TEST(Labels, BadBoxesAreOneLineWithFileAndLine) {
  const auto ring = vision::buildRingTable({});
  const auto outside = written("outside.txt", "\nwhite.png 0 0 300 10 white\n");
  EXPECT_EQ(readRegions(outside, ring).error(),
            outside + ":2: the box must lie in 208 x 160 pixels");
  const auto unknown = written("unknown.txt", "white.png 0 0 10 10 purple\n");
  EXPECT_EQ(readRegions(unknown, ring).error(), unknown + ":1: no class 'purple', " + kClasses);
  const auto few = written("few.txt", "white.png 0 0 white\n");
  EXPECT_EQ(readRegions(few, ring).error(),
            few + ":1: expected: image left top right bottom class");
  const auto empty = written("empty.txt", "# nothing\n");
  EXPECT_EQ(readRegions(empty, ring).error(), empty + ": no labelled boxes");
}

TEST(Images, GenuineFramesLayoutHasTheChannelsRowByRow) {
  std::string bytes(3 * kImagePixels, '\0');
  bytes[3 * 208 * 2 + 7] = 'Y';            // row 2, column 7
  bytes[3 * 208 * 2 + 208 + 7] = 'r';      // its Cr
  bytes[3 * 208 * 2 + 2 * 208 + 7] = 'b';  // its Cb
  const auto image = readImage(written("rows.bin", bytes));
  ASSERT_TRUE(image) << image.error();
  const Yuv p = image->pixel(7, 2);
  EXPECT_EQ(p.y, 'Y');
  EXPECT_EQ(p.cr, 'r');
  EXPECT_EQ(p.cb, 'b');
}

TEST(Images, WrongSizeAndEmptyFolderAreOneLine) {
  const auto small = written("small.bin", "123");
  EXPECT_EQ(readImage(small).error(),
            small + ": 3 bytes, expected 99840 (planes Y, Cr, Cb of 208 x 160)");
  const auto folder = inFolder("nothing_here");
  std::filesystem::create_directories(folder);
  EXPECT_EQ(readImages(folder, 10).error(), folder + ": no .png, .yuv or .bin images");
  EXPECT_EQ(readImages("no/such", 10).error(), "no/such: no such folder or log");
}

}  // namespace
}  // namespace kelpie::calibrate
