// SPDX-License-Identifier: Apache-2.0
// Three frames of a real ERS-7 (Tekkotsu) through the 2005 team's table: another robot, another
// room, so shares are only plausible. Pictures of the classes are written to the build folder.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

#include "tests/vision/Painting.h"
#include "tools/picture/PngFile.h"
#include "vision/Vision.h"
#include "vision/colour/TableFile.h"
#include "vision/pixels/ClassPicture.h"

namespace kelpie::vision {
namespace {

const std::string kData = KELPIE_SOURCE_DIR "/../shared/data/";

bool readFrame(int number, Image& image) {
  auto bytes =
      readBytes(kData + "frames-ers7/frame" + std::to_string(number) + "_y_cr_cb_rows.bin");
  if (!bytes || bytes->size() != 3 * kImagePixels) return false;
  for (int y = 0; y < kImageHeight; ++y) {
    for (int x = 0; x < kImageWidth; ++x) {
      const std::size_t at = static_cast<std::size_t>(y) * 3 * kImageWidth;
      const auto in = [&](std::size_t row) {
        return (*bytes)[at + row * kImageWidth + static_cast<std::size_t>(x)];
      };
      image.set(x, y, {in(0), in(1), in(2)});
    }
  }
  return true;
}

void writePicture(const ClassPlane& plane, const std::string& path) {
  cv::Mat picture(kImageHeight, kImageWidth, CV_8UC3);
  for (int y = 0; y < kImageHeight; ++y) {
    for (int x = 0; x < kImageWidth; ++x) {
      const Rgb c = kColourPalette[plane[Image::at(x, y)]];
      picture.at<cv::Vec3b>(y, x) = {c.b, c.g, c.r};
    }
  }
  const Status written = picture::writePng(path, picture);
  EXPECT_TRUE(written) << written.error();
}

using Shares = std::array<double, kColourClassCount>;

Shares sharesOf(const ClassPlane& plane) {
  Shares shares{};
  for (const std::uint8_t c : plane) shares[c] += 1.0 / static_cast<double>(kImagePixels);
  return shares;
}

class GenuineFrames : public ::testing::Test {
 protected:
  void SetUp() override {
    auto loaded = loadCalibration(kData + "colour/nnmc_2005.bin", "2006");
    if (!loaded) GTEST_SKIP() << "without ../shared/data: " << loaded.error();
    calibration_ = std::make_unique<VisionCalibration>(*loaded);
  }
  const ClassPlane& classes(int number) {
    EXPECT_TRUE(readFrame(number, *image_));
    classifyWhole(*image_, *calibration_, *plane_);
    return *plane_;
  }
  Shares shares(int number) { return sharesOf(classes(number)); }
  std::unique_ptr<VisionCalibration> calibration_;
  std::unique_ptr<Image> image_ = std::make_unique<Image>();
  std::unique_ptr<ClassPlane> plane_ = std::make_unique<ClassPlane>();
};

TEST_F(GenuineFrames, CarpetAndColouredThingsHavePlausibleShares) {
  const Shares third = shares(3);
  const Shares fourth = shares(4);
  EXPECT_GT(third[index(ColourClass::green)], 0.02);
  EXPECT_GT(fourth[index(ColourClass::green)], 0.08);
  for (const Shares& s : {third, fourth}) {
    EXPECT_GT(s[index(ColourClass::orange)], 0.08);
    EXPECT_GT(s[index(ColourClass::blue)], 0.02);
    EXPECT_LT(s[index(ColourClass::white)], 0.2);
  }
}

TEST_F(GenuineFrames, CartonWithoutCarpetHasLessGreenThanTheCarpet) {
  EXPECT_LT(shares(1)[index(ColourClass::green)], shares(4)[index(ColourClass::green)]);
}

// In a test of its own: tests run side by side, and two that write one file disturb each other.
TEST_F(GenuineFrames, PicturesOfTheirClassesAreWritten) {
  for (const int number : {1, 3, 4})
    writePicture(classes(number),
                 KELPIE_PICTURES "/frame" + std::to_string(number) + "_classes.png");
}

TEST_F(GenuineFrames, WholeStepRunsAndFindsNoBeacon) {
  const auto state = std::make_unique<VisionState>(*calibration_);
  const auto input = std::make_unique<FrameInput>();
  for (const int number : {1, 3, 4}) {
    ASSERT_TRUE(readFrame(number, input->image));
    const Percepts seen = step({*input, bodyOf(cameraAt(20, 0, -20))}, {}, *state);
    EXPECT_GT(seen.counts.sampledPixels, 4500U);
    EXPECT_GT(seen.counts.blobs, 3U);
    for (const auto& landmark : seen.landmarks) {
      EXPECT_LE(landmark.kind, LandmarkKind::goalYellow) << "there is no beacon in these frames";
    }
  }
}

using Marks = FixedVector<ObstaclePoint, 64>;

int marksIn(const Marks& marks, const PixelBox& box) {
  return static_cast<int>(std::count_if(marks.begin(), marks.end(), [&](const ObstaclePoint& m) {
    return m.pixel.x >= box.left && m.pixel.x < box.right && m.pixel.y >= box.top &&
           m.pixel.y < box.bottom;
  }));
}

// Half of this carpet's pixels are green to the 2005 table, the others none, dark or grey.
TEST_F(GenuineFrames, BareDarkCarpetIsNoObstacleTheFeetOfThingsOnItAre) {
  const auto state = std::make_unique<VisionState>(*calibration_);
  const auto input = std::make_unique<FrameInput>();
  const auto marks = [&](int number) {
    EXPECT_TRUE(readFrame(number, input->image));
    return step({*input, bodyOf(cameraAt(20, 0, -20))}, {}, *state).obstacles;
  };
  const Marks third = marks(3);
  EXPECT_EQ(marksIn(third, {167, 84, 208, 160}), 0);
  EXPECT_EQ(marksIn(third, {145, 115, 208, 160}), 0);
  EXPECT_EQ(marksIn(third, {20, 145, 208, 160}), 0);
  EXPECT_GE(marksIn(third, {75, 130, 110, 145}), 2) << "the ball's foot";
  const Marks fourth = marks(4);
  EXPECT_EQ(marksIn(fourth, {0, 90, 40, 160}), 0);
  EXPECT_EQ(marksIn(fourth, {40, 130, 208, 160}), marksIn(fourth, {175, 130, 208, 138}));
  EXPECT_GE(marksIn(fourth, {105, 85, 135, 96}), 3) << "the can's foot";
}

}  // namespace
}  // namespace kelpie::vision
