// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "tests/calibrate/SheetMaker.h"
#include "tools/calibrate/ring/RingLearner.h"
#include "tools/calibrate/ring/RingSimplex.h"

namespace kelpie::calibrate {
namespace {

using vision::ringModel2006;

// Largest difference of F over the image for the values that the papers span.
double worstError(const vision::RingModel& learnt, const vision::RingModel& truth) {
  constexpr std::array<std::array<int, 2>, 3> kSpans = {{{77, 189}, {103, 160}, {61, 167}}};
  double worst = 0.0;
  for (std::size_t c = 0; c < 3; ++c)
    for (int d = 0; d <= 132; d += 4)
      for (int v = kSpans[c][0]; v <= kSpans[c][1]; v += 4)
        worst = std::fmax(worst, std::fabs(ringDistort(learnt.channel[c], v, d) -
                                           ringDistort(truth.channel[c], v, d)));
  return worst;
}

// 100 at 10 px: 99.5, seen 99; 200 at 20 px: 197, seen 199; 50 at 100 px: 50, seen 51.
TEST(RingError, OfThreePixelsIsTheOneComputedByHand) {
  const vision::RingChannel model{0, 0, 0, 0, -0.001, 0.05};
  EXPECT_NEAR(meanSquareError({{10, 99, 100}, {20, 199, 200}, {100, 51, 50}}, model),
              (0.25 + 4.0 + 1.0) / 3, 1e-9);
}

TEST(RingLearner, FindsTheRingEffectOfEvenSheets) {
  const auto fit = learnRing(sheetsOf(allPapers(), ringModel2006()), {});
  ASSERT_TRUE(fit) << fit.error();
  EXPECT_LT(worstError(fit->model, ringModel2006()), 1.0);
  for (const auto& channel : fit->channel) EXPECT_NEAR(channel.after, 1.85, 0.15);
}

TEST(RingLearner, FindsACentreForEachChannel) {
  auto truth = ringModel2006();
  truth.centre = {{{110, 80}, {105, 76}, {97, 84}}};
  const auto fit = learnRing(sheetsOf(allPapers(), truth), {});
  ASSERT_TRUE(fit) << fit.error();
  for (std::size_t c = 0; c < 3; ++c) {
    EXPECT_NEAR(fit->model.centre[c].column, truth.centre[c].column, 1.0);
    EXPECT_NEAR(fit->model.centre[c].row, truth.centre[c].row, 1.0);
    // As it is used: a half pixel would be rounded away from the truth.
    EXPECT_EQ(fit->channel[c].centre[0], fit->model.centre[c].column);
    EXPECT_EQ(fit->channel[c].centre[1], fit->model.centre[c].row);
  }
  EXPECT_LT(worstError(fit->model, truth), 1.0);
}

TEST(RingLearner, LeavesOutASheetThatIsNotEven) {
  auto sheets = sheetsOf(allPapers(), ringModel2006());
  vision::RingModel bright;  // a lamp shines on its rim
  bright.channel[0].a3 = 0.003;
  sheets.push_back(sheetsOf({kPapers[0]}, bright)[0]);
  sheets.back().name = "lamp";
  const auto fit = learnRing(sheets, {});
  ASSERT_TRUE(fit) << fit.error();
  EXPECT_EQ(fit->leftOut, std::vector<std::string>{"lamp"});
  EXPECT_LT(worstError(fit->model, ringModel2006()), 1.0);
}

TEST(RingLearner, IgnoresAFingerInThePicture) {
  auto sheets = sheetsOf(allPapers(), ringModel2006());
  for (auto& pixel : sheets[2].pixels)
    if (pixel.px > 150 && pixel.py < 80) pixel.value = {60, 150, 110};
  const auto fit = learnRing(sheets, {});
  ASSERT_TRUE(fit) << fit.error();
  EXPECT_LT(worstError(fit->model, ringModel2006()), 1.0);
}

TEST(RingLearner, SimplexFindsNothingBetterThanLeastSquares) {
  const auto fit = learnRing(sheetsOf(allPapers(), ringModel2006()), {});
  ASSERT_TRUE(fit) << fit.error();
  for (std::size_t c = 0; c < 3; ++c) {
    const auto check = checkWithSimplex(*fit, c);
    EXPECT_NEAR(check.simplex, check.squares, 0.002 * check.squares);
  }
}

TEST(RingLearner, OneSheetIsRefused) {
  EXPECT_EQ(learnRing(sheetsOf({kPapers[0]}, ringModel2006()), {}).error(),
            "one sheet cannot tell gain from offset: give sheets of several colours");
}

TEST(RingLearner, SheetsOfOneColourAreRefused) {
  const auto fit = learnRing(sheetsOf({kPapers[0], kPapers[0]}, ringModel2006()), {});
  EXPECT_NE(fit.error().find("the sheets' Y spans 0 grey levels, at least 15"), std::string::npos)
      << fit.error();
}

TEST(RingLearner, ImagesThatAreNoSheetsAreRefused) {
  auto sheets = sheetsOf(allPapers(), ringModel2006());
  Random random(5);
  for (auto& sheet : sheets)
    for (auto& pixel : sheet.pixels) pixel.value.y = static_cast<std::uint8_t>(random.index(200));
  EXPECT_NE(learnRing(sheets, {}).error().find("no even sheets: Y"), std::string::npos);
}

TEST(RingLearner, WithThePublishedPolynomialsHelpOneColourWillDo) {
  RingLearnParams params;
  params.priorShare = 0.05;
  params.findCentre = false;
  const auto fit = learnRing(sheetsOf({kPapers[1]}, ringModel2006()), params);
  ASSERT_TRUE(fit) << fit.error();
  EXPECT_LT(worstError(fit->model, ringModel2006()), 3.0);
}

TEST(RingLearner, NoPixelsAreOneLine) {
  EXPECT_EQ(learnRing({{"empty", {}}}, {}).error(), "no sheet with 200 usable pixels");
}

TEST(Sheets, DominantSurfaceIsTheCarpetNotTheThingOnIt) {
  Random random(3);
  Image image = sheetImage(kPapers[1], ringModel2006(), random);
  for (int py = 40; py < 100; ++py)
    for (int px = 60; px < 150; ++px) image.set(px, py, {140, 181, 79});
  const Sheet surface = dominantSurface("carpet", image, 2);
  EXPECT_GT(surface.pixels.size(), 5500U);  // of 7800 samples, 1350 of them on the thing
  for (const auto& p : surface.pixels) EXPECT_NE(p.value.cr, 181);
}

}  // namespace
}  // namespace kelpie::calibrate
