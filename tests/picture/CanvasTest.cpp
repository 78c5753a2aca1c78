// SPDX-License-Identifier: Apache-2.0
// Set type and smooth lines.
#include <gtest/gtest.h>

#include "tools/picture/Canvas.h"

namespace kelpie::picture {
namespace {

constexpr Ink kBlack{0.0, 0.0, 0.0};
constexpr Ink kOrange{1.0, 0.5, 0.0};

cv::Vec3b at(const Canvas& canvas, int x, int y) { return canvas.picture().at<cv::Vec3b>(y, x); }

int written(const Canvas& canvas) { return cv::countNonZero(canvas.picture().reshape(1)); }

TEST(Canvas, HasTheColoursOfItsInks) {
  auto canvas = Canvas::create({40, 30}, kBlack);
  ASSERT_TRUE(canvas) << canvas.error();
  canvas->box({10, 10, 20, 10}, kOrange);
  EXPECT_EQ(at(*canvas, 20, 15), cv::Vec3b(0, 128, 255));
  EXPECT_EQ(at(*canvas, 5, 5), cv::Vec3b(0, 0, 0));
}

TEST(Canvas, WritesWhereItIsToldAndTellsHowWide) {
  auto canvas = Canvas::create({200, 60}, kBlack);
  ASSERT_TRUE(canvas) << canvas.error();
  const Type type{20.0, kOrange};
  const cv::Size2d size = canvas->text({10, 10}, "kelpie", type);
  EXPECT_EQ(size, canvas->measure("kelpie", type));
  EXPECT_GT(size.width, 40.0);
  EXPECT_LT(size.width, 100.0);
  EXPECT_GT(written(*canvas), 200);
  EXPECT_EQ(cv::countNonZero(canvas->picture().colRange(120, 200).clone().reshape(1)), 0);
}

TEST(Canvas, BreaksTextIntoLinesAndShortensTheRest) {
  const auto canvas = Canvas::create({200, 200}, kBlack);
  ASSERT_TRUE(canvas) << canvas.error();
  const std::string words = "one two three four five six seven eight nine ten eleven twelve";
  Type type{14.0, kOrange};
  const double one = canvas->measure(words, type, 100.0).height;
  type.lines = 3;
  const cv::Size2d three = canvas->measure(words, type, 100.0);
  EXPECT_NEAR(three.height, 3.0 * one, 3.0);
  EXPECT_LE(three.width, 101.0);
}

TEST(Canvas, WritesLettersBeyondAsciiAndWhatIsNoText) {
  auto canvas = Canvas::create({200, 60}, kBlack);
  ASSERT_TRUE(canvas) << canvas.error();
  EXPECT_GT(canvas->text({10, 10}, "12° · ä", {20.0, kOrange}).width, 40.0);
  EXPECT_GT(canvas->text({10, 30}, "\xff\xfe broken", {20.0, kOrange}).width, 40.0);
}

TEST(Canvas, DrawsNothingOutsideACut) {
  auto canvas = Canvas::create({100, 100}, kBlack);
  ASSERT_TRUE(canvas) << canvas.error();
  canvas->cut({0, 0, 50, 100});
  canvas->disc({50, 50}, 30, kOrange);
  canvas->uncut();
  EXPECT_EQ(at(*canvas, 40, 50), cv::Vec3b(0, 128, 255));
  EXPECT_EQ(at(*canvas, 60, 50), cv::Vec3b(0, 0, 0));
}

TEST(Canvas, PastesAPictureStretched) {
  auto canvas = Canvas::create({100, 100}, kBlack);
  ASSERT_TRUE(canvas) << canvas.error();
  canvas->paste(cv::Mat(10, 10, CV_8UC3, cv::Scalar(200, 100, 50)), {20, 20, 60, 60});
  EXPECT_EQ(at(*canvas, 50, 50), cv::Vec3b(200, 100, 50));
  EXPECT_EQ(at(*canvas, 10, 50), cv::Vec3b(0, 0, 0));
}

}  // namespace
}  // namespace kelpie::picture
