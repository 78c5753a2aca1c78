// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>

#include "robot/core/Random.h"
#include "tools/picture/CameraPicture.h"
#include "tools/picture/FilmFile.h"
#include "tools/picture/Jpeg.h"
#include "tools/picture/PngFile.h"

namespace kelpie::picture {
namespace {

// A file name of this test, removed with the object.
struct TestFile {
  std::string path = testing::TempDir() + "kelpie_" +
                     testing::UnitTest::GetInstance()->current_test_info()->name();
  explicit TestFile(const char* ending) { path += ending; }
  TestFile(const TestFile&) = delete;
  TestFile& operator=(const TestFile&) = delete;
  ~TestFile() { std::remove(path.c_str()); }
};

// Broad shapes in the colours of a field, as a camera sees them.
Image shapes(Random& random) {
  Image image;
  for (int y = 0; y < kImageHeight; ++y)
    for (int x = 0; x < kImageWidth; ++x) {
      const bool ball = std::hypot(x - 100, y - 80) < 30;
      const double noise = random.gaussian(0.0, 1.5);
      const auto luma = static_cast<std::uint8_t>(std::lround((ball ? 140 : 77) + noise));
      image.set(x, y, ball ? Yuv{luma, 181, 79} : Yuv{luma, 103, 97});
    }
  return image;
}

double meanDifference(const Image::Plane& a, const Image::Plane& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += std::abs(a[i] - b[i]);
  return sum / static_cast<double>(a.size());
}

TEST(CameraPicture, GoesThereAndBackWithinARounding) {
  Random random(4);
  const Image image = shapes(random);
  const Image again = imageOf(pictureOf(image));
  EXPECT_LT(meanDifference(image.y, again.y), 1.0);
  EXPECT_LT(meanDifference(image.cr, again.cr), 1.0);
  EXPECT_LT(meanDifference(image.cb, again.cb), 1.0);
}

TEST(IndexedPng, GivesBackTheColourOfEachNumber) {
  const TestFile file(".png");
  const std::vector<cv::Vec3b> palette = {{1, 2, 3}, {200, 100, 0}, {255, 255, 255}};
  cv::Mat numbers(2, 3, CV_8UC1);
  for (int i = 0; i < 6; ++i)
    numbers.at<std::uint8_t>(i / 3, i % 3) = static_cast<std::uint8_t>(i / 2);
  ASSERT_TRUE(writeIndexedPng(file.path, numbers, palette));
  const auto again = readPng(file.path);
  ASSERT_TRUE(again) << again.error();
  ASSERT_EQ(again->size(), numbers.size());
  for (int i = 0; i < 6; ++i)
    EXPECT_EQ(again->at<cv::Vec3b>(i / 3, i % 3), palette[static_cast<std::size_t>(i / 2)]);
}

TEST(IndexedPng, RefusesAPictureThatIsNoTableOfNumbers) {
  const TestFile file(".png");
  EXPECT_FALSE(writeIndexedPng(file.path, cv::Mat(2, 2, CV_8UC3), {{0, 0, 0}}));
}

TEST(Jpeg, IsSmallAndLooksTheSame) {
  Random random(5);
  const Image image = shapes(random);
  const auto bytes = jpegOf(image, 65);
  ASSERT_FALSE(bytes.empty());
  EXPECT_LT(bytes.size(), 5000U);
  Image again;
  ASSERT_TRUE(imageOfJpeg(bytes.data(), bytes.size(), again));
  EXPECT_LT(meanDifference(image.y, again.y), 3.0);
  EXPECT_LT(meanDifference(image.cr, again.cr), 3.0);
  EXPECT_LT(meanDifference(image.cb, again.cb), 3.0);
}

TEST(Jpeg, RefusesWhatIsNone) {
  Random random(6);
  auto bytes = jpegOf(shapes(random), 65);
  Image image;
  EXPECT_FALSE(imageOfJpeg(bytes.data(), 0, image));
  EXPECT_FALSE(imageOfJpeg(bytes.data(), 20, image));
  for (auto& byte : bytes) byte = static_cast<std::uint8_t>(random.next());
  EXPECT_FALSE(imageOfJpeg(bytes.data(), bytes.size(), image));
}

TEST(Png, GivesBackEveryPixel) {
  const TestFile file(".png");
  cv::Mat picture(7, 5, CV_8UC3);
  cv::randu(picture, 0, 256);
  ASSERT_TRUE(writePng(file.path, picture));
  const auto again = readPng(file.path);
  ASSERT_TRUE(again) << again.error();
  EXPECT_EQ(cv::norm(picture, *again, cv::NORM_INF), 0.0);
}

TEST(Png, InFewColoursIsSmallerAndLooksTheSame) {
  const TestFile whole(".png");
  const TestFile small(".small.png");
  Random random(7);
  const cv::Mat picture = pictureOf(shapes(random));
  ASSERT_TRUE(writePng(whole.path, picture));
  ASSERT_TRUE(writeSmallPng(small.path, picture));
  EXPECT_LT(std::filesystem::file_size(small.path), std::filesystem::file_size(whole.path) / 2);
  const auto again = readPng(small.path);
  ASSERT_TRUE(again) << again.error();
  EXPECT_LT(cv::norm(picture, *again, cv::NORM_L1) / static_cast<double>(3 * picture.total()), 2.0);
}

TEST(Png, NamesAFileThatIsNone) {
  const TestFile file(".png");
  std::ofstream(file.path) << "no picture";
  const auto picture = readPng(file.path);
  ASSERT_FALSE(picture);
  EXPECT_NE(picture.error().find(file.path), std::string::npos);
  EXPECT_FALSE(writePng("/dev/null/x.png", cv::Mat(2, 2, CV_8UC3)));
}

TEST(Film, IsWholeWhenItIsClosed) {
  const TestFile file(".mp4");
  auto film = FilmFile::create(file.path, {64, 48}, 30);
  ASSERT_TRUE(film) << film.error();
  for (int i = 0; i < 40; ++i)
    ASSERT_TRUE(film->add(cv::Mat(48, 64, CV_8UC3, cv::Scalar(i * 6, 0, 0))));
  ASSERT_TRUE(film->close());
  std::ifstream in(file.path, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(in), {}};
  EXPECT_EQ(bytes.substr(4, 4), "ftyp");
  EXPECT_NE(bytes.find("moov"), std::string::npos);  // the index, written by close()
}

TEST(Film, OfAFullDiskIsAnError) {
  if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "no /dev/full on this machine";
  auto film = FilmFile::create("/dev/full", {64, 48}, 30);
  Status status = film ? Status(Done{}) : Status(Error{film.error()});
  for (int i = 0; i < 100 && status; ++i) {
    cv::Mat noise(48, 64, CV_8UC3);
    cv::randu(noise, 0, 256);
    status = film->add(noise);
  }
  if (status) status = film->close();
  ASSERT_FALSE(status);
  EXPECT_NE(status.error().find("No space left"), std::string::npos) << status.error();
}

}  // namespace
}  // namespace kelpie::picture
