// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <memory>

#include "vision/Blobs.h"
#include "vision/VisionState.h"

namespace kelpie::vision {
namespace {

// An image of classes: the plane is filled by hand, the pixels behind it are never read.
struct Canvas {
  std::unique_ptr<VisionState> state = std::make_unique<VisionState>(VisionCalibration{});
  std::unique_ptr<Image> image = std::make_unique<Image>();

  Canvas() { state->classes.fill(static_cast<std::uint8_t>(ColourClass::none)); }
  void box(ColourClass c, int left, int top, int right, int bottom) {
    for (int y = top; y < bottom; ++y) {
      for (int x = left; x < right; ++x) {
        state->classes[Image::at(x, y)] = static_cast<std::uint8_t>(c);
      }
    }
  }
  const BlobBuffer& blobs() {
    const Sampler sampler(*image, state->calibration, state->distances, state->classes);
    lost = findBlobs(sampler, state->runs, state->blobs);
    return state->blobs;
  }
  std::uint32_t lost = 0;
};

TEST(Blobs, BoxAndCentreAreThoseOfThePatch) {
  Canvas canvas;
  canvas.box(ColourClass::orange, 40, 60, 60, 70);
  const auto& blobs = canvas.blobs();
  ASSERT_EQ(blobs.size(), 1U);
  EXPECT_EQ(blobs[0].samples, 10U * 5U);
  EXPECT_NEAR(blobs[0].box.left, 40, 1);
  EXPECT_NEAR(blobs[0].box.right, 60, 1);
  EXPECT_NEAR(blobs[0].centre.x, 50, 1);
  EXPECT_NEAR(blobs[0].centre.y, 65, 1);
}

TEST(Blobs, ArmsOfAUThatMeetBelowAreOne) {
  Canvas canvas;
  canvas.box(ColourClass::blue, 20, 20, 26, 60);
  canvas.box(ColourClass::blue, 60, 20, 66, 60);
  canvas.box(ColourClass::blue, 20, 60, 66, 66);
  EXPECT_EQ(canvas.blobs().size(), 1U);
}

TEST(Blobs, PatchesOfTwoColoursThatTouchAreTwo) {
  Canvas canvas;
  canvas.box(ColourClass::pink, 20, 20, 40, 40);
  canvas.box(ColourClass::blue, 20, 40, 40, 60);
  EXPECT_EQ(canvas.blobs().size(), 2U);
}

TEST(Blobs, CornersThatTouchOnTheLatticeJoin) {
  Canvas canvas;
  canvas.box(ColourClass::pink, 20, 20, 30, 30);
  canvas.box(ColourClass::pink, 30, 30, 40, 40);
  EXPECT_EQ(canvas.blobs().size(), 1U);
}

TEST(Blobs, UniformsOfBothTeamsFormThem) {
  Canvas canvas;
  canvas.box(ColourClass::robotRed, 20, 20, 30, 30);
  canvas.box(ColourClass::robotBlue, 40, 20, 50, 30);
  EXPECT_EQ(canvas.blobs().size(), 2U);
}

TEST(Blobs, GreenAndWhiteFormNone) {
  Canvas canvas;
  canvas.box(ColourClass::green, 0, 60, 208, 160);
  canvas.box(ColourClass::white, 50, 80, 60, 100);
  EXPECT_TRUE(canvas.blobs().empty());
}

TEST(Blobs, AnImageFullOfSpecksIsCountedAsLostNotOverrun) {
  Canvas canvas;
  for (int y = 0; y < kImageHeight; ++y) {
    for (int x = 0; x < kImageWidth; ++x) {
      if ((x / 2 + (y / 2 % 2) * 2) % 4 == 0) canvas.box(ColourClass::orange, x, y, x + 1, y + 1);
    }
  }
  EXPECT_LE(canvas.blobs().size(), BlobBuffer::kCapacity);
  EXPECT_GT(canvas.lost, 0U);
}

}  // namespace
}  // namespace kelpie::vision
