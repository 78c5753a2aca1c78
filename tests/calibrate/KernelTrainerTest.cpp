// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <filesystem>

#include "tools/calibrate/SharedData.h"
#include "tools/calibrate/colour/KernelTrainer.h"
#include "tools/calibrate/colour/TablePicture.h"

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

TEST(KernelTrainer, CloudsThatLieApartAreDistinguished) {
  const auto table = trainClasses(threeClouds(), {}, {});
  EXPECT_GT(accuracyOf(confusionOf(table, threeClouds())), 0.99);
  EXPECT_EQ(table({140, 181, 79}), ColourClass::orange);
  EXPECT_EQ(table({113, 190, 124}), ColourClass::pink);
}

TEST(KernelTrainer, ColoursFarFromEveryLabelAreNone) {
  const auto table = trainClasses(threeClouds(), {}, {});
  EXPECT_EQ(table({220, 60, 220}), ColourClass::none);
  EXPECT_EQ(table({20, 128, 128}), ColourClass::none);
}

TEST(KernelTrainer, OneStrayLabelDoesNotTakeACloud) {
  auto pixels = threeClouds();
  pixels.push_back({{140, 181, 79}, ColourClass::yellow});
  EXPECT_EQ(trainClasses(pixels, {}, {})({140, 181, 79}), ColourClass::orange);
}

TEST(KernelTrainer, RobotTableHasTheTrainedClasses) {
  const auto trained = trainClasses(threeClouds(), {}, {});
  const auto table = robotTable(trained);
  for (const auto& p : threeClouds()) ASSERT_EQ(table(p.value), trained(p.value));
}

TEST(KernelTrainer, NothingLabelledGivesAnEmptyTable) {
  EXPECT_EQ(trainClasses({}, {}, {})({140, 181, 79}), ColourClass::none);
}

TEST(KernelTrainer, TheOnlyClassLabelledTakesWhatIsNearItsLabels) {
  const auto trained = trainClasses({{{140, 181, 79}, ColourClass::orange}}, {}, {});
  EXPECT_EQ(trained({142, 183, 81}), ColourClass::orange);
  EXPECT_EQ(trained({140, 128, 128}), ColourClass::none);
}

TEST(KernelTrainer, WhereBallAndBeaconPinkLieInOneAnotherTheBallIsRatherNotMissed) {
  Random random(5);
  LabelledPixels pixels;
  addCloud(pixels, {120, 184, 100}, ColourClass::orange, 300, random);
  addCloud(pixels, {120, 187, 104}, ColourClass::pink, 300, random);
  const auto recalls = [&](double ballCost) {
    KernelParams params;
    params.ballCost = ballCost;
    const auto confusion = confusionOf(trainClasses(pixels, params, {}), pixels);
    return std::array{recallOf(confusion, ColourClass::orange),
                      recallOf(confusion, ColourClass::pink)};
  };
  EXPECT_GT(recalls(1.5)[0], recalls(1.0)[0] + 0.05);
  EXPECT_LT(recalls(1.5)[1], recalls(1.0)[1]);
}

TEST(KernelTrainer, RecallIsOfWhatIsLabelledPrecisionOfWhatIsFound) {
  Confusion confusion{};
  const auto orange = vision::index(ColourClass::orange);
  const auto pink = vision::index(ColourClass::pink);
  confusion[orange][orange] = 6;
  confusion[orange][pink] = 2;
  confusion[pink][orange] = 4;
  EXPECT_DOUBLE_EQ(recallOf(confusion, ColourClass::orange), 0.75);
  EXPECT_DOUBLE_EQ(precisionOf(confusion, ColourClass::orange), 0.6);
  EXPECT_DOUBLE_EQ(recallOf(confusion, ColourClass::blue), 0.0);
}

TEST(KernelTrainer, NearestNeighboursVote) {
  const LabelledPixels pixels{{{10, 10, 10}, ColourClass::black},
                              {{12, 10, 10}, ColourClass::robotBlue},
                              {{14, 10, 10}, ColourClass::robotBlue}};
  EXPECT_EQ(nearestNeighbours(pixels, {10, 10, 10}, 1), ColourClass::black);
  EXPECT_EQ(nearestNeighbours(pixels, {10, 10, 10}, 3), ColourClass::robotBlue);
}

// Sums of four splits; `kelpie evaluate colour` has forty.
TEST(KernelTrainer, BeatsThe2005TableAndNineNeighboursOnHeldOutLabelsAndOnTheBalls) {
  const auto folder = sharedData() + "colour/";
  const auto pixels = readLabelledCsv(folder + "labelled_samples.csv");
  const auto released = vision::loadColourTable(folder + "nnmc_2005.bin");
  if (!pixels || !released) GTEST_SKIP() << "without ../shared/data/colour";
  Random random(77);
  Confusion trained{}, old{}, near{};
  for (int i = 0; i < 4; ++i) {
    const auto split = splitLabelled(*pixels, 0.25, random);
    const auto neighbours = [&](Yuv v) { return nearestNeighbours(split.training, v, 9); };
    addTo(trained, confusionOf(trainClasses(split.training, {}, {}), split.heldOut));
    addTo(old, confusionOf(*released, split.heldOut));
    addTo(near, confusionOf(neighbours, split.heldOut));
  }
  EXPECT_GT(accuracyOf(trained), accuracyOf(near));
  EXPECT_GT(accuracyOf(trained), accuracyOf(old) + 0.2);
  EXPECT_GT(recallOf(trained, ColourClass::orange), recallOf(near, ColourClass::orange));
}

TEST(TablePicture, UnknownKindOfPictureIsOneLine) {
  const std::string path = KELPIE_OUT "/table.nonsense";
  EXPECT_EQ(writeTablePicture(*std::make_unique<vision::ColourTable>(), path).error(),
            path + ": cannot be written as a picture");
}

}  // namespace
}  // namespace kelpie::calibrate
