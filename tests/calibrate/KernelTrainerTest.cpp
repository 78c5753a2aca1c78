// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <filesystem>

#include "tools/calibrate/KernelTrainer.h"
#include "tools/calibrate/SharedData.h"
#include "tools/calibrate/TablePicture.h"

namespace kelpie::calibrate {
namespace {

using vision::ColourClass;

// `count` pixels of a class about a colour, sd 4.
void addCloud(LabelledPixels& pixels, Yuv middle, ColourClass colour, int count, Random& random) {
  const auto near = [&](std::uint8_t v) {
    return static_cast<std::uint8_t>(v + random.gaussian(0.0, 4.0));
  };
  for (int i = 0; i < count; ++i)
    pixels.push_back({{near(middle.y), near(middle.cr), near(middle.cb)}, colour});
}

LabelledPixels threeClouds() {
  Random random(4);
  LabelledPixels pixels;
  addCloud(pixels, {140, 181, 79}, ColourClass::orange, 300, random);
  addCloud(pixels, {113, 190, 124}, ColourClass::pink, 100, random);
  addCloud(pixels, {77, 103, 97}, ColourClass::green, 300, random);
  return pixels;
}

TEST(KernelTrainer, CloudsThatLieApartAreToldApart) {
  const auto table = trainTable(threeClouds(), {}, {});
  EXPECT_GT(accuracyOf(confusionOf(table, threeClouds())), 0.99);
  EXPECT_EQ(table({140, 181, 79}), ColourClass::orange);
  EXPECT_EQ(table({113, 190, 124}), ColourClass::pink);
}

TEST(KernelTrainer, ColoursFarFromEveryLabelAreNone) {
  const auto table = trainTable(threeClouds(), {}, {});
  EXPECT_EQ(table({220, 60, 220}), ColourClass::none);
  EXPECT_EQ(table({20, 128, 128}), ColourClass::none);
}

TEST(KernelTrainer, OneStrayLabelDoesNotTakeACloud) {
  auto pixels = threeClouds();
  pixels.push_back({{140, 181, 79}, ColourClass::yellow});
  EXPECT_EQ(trainTable(pixels, {}, {})({140, 181, 79}), ColourClass::orange);
}

TEST(KernelTrainer, RobotTableHasTheGridsClasses) {
  const auto grid = trainTable(threeClouds(), {}, {});
  const auto table = robotTable(grid);
  for (std::size_t cell = 0; cell < vision::ColourTable::kCells; ++cell)
    ASSERT_EQ(table.at(cell), grid.cells[cell]);
}

TEST(KernelTrainer, NothingLabelledGivesAnEmptyTable) {
  EXPECT_EQ(trainTable({}, {}, {})({140, 181, 79}), ColourClass::none);
}

TEST(KernelTrainer, NearestNeighboursVote) {
  const LabelledPixels pixels{{{10, 10, 10}, ColourClass::black},
                              {{12, 10, 10}, ColourClass::robotBlue},
                              {{14, 10, 10}, ColourClass::robotBlue}};
  EXPECT_EQ(nearestNeighbours(pixels, {10, 10, 10}, 1), ColourClass::black);
  EXPECT_EQ(nearestNeighbours(pixels, {10, 10, 10}, 3), ColourClass::robotBlue);
}

// Means of four splits; `kelpie evaluate colour` has the figures with cross-validation.
TEST(KernelTrainer, BeatsThe2005TableAndNineNeighboursOnHeldOutLabels) {
  const auto folder = sharedData() + "colour/";
  const auto pixels = readLabelledCsv(folder + "labelled_samples.csv");
  const auto released = vision::loadColourTable(folder + "nnmc_2005.bin");
  if (!pixels || !released) GTEST_SKIP() << "without ../shared/data/colour";
  Random random(77);
  double trained = 0.0, old = 0.0, near = 0.0;
  for (int i = 0; i < 4; ++i) {
    const auto split = splitLabelled(*pixels, 0.25, random);
    const auto neighbours = [&](Yuv v) { return nearestNeighbours(split.training, v, 9); };
    trained += accuracyOf(confusionOf(trainTable(split.training, {}, {}), split.heldOut)) / 4;
    old += accuracyOf(confusionOf(*released, split.heldOut)) / 4;
    near += accuracyOf(confusionOf(neighbours, split.heldOut)) / 4;
  }
  EXPECT_GT(trained, near);
  EXPECT_GT(trained, old + 0.2);
}

TEST(TablePicture, UnknownKindOfPictureIsOneLine) {
  const std::string path = KELPIE_OUT "/table.nonsense";
  EXPECT_EQ(writeTablePicture(*std::make_unique<vision::ColourTable>(), path).error(),
            path + ": cannot be written as a picture");
}

}  // namespace
}  // namespace kelpie::calibrate
