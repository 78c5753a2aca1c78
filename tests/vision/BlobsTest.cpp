// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <memory>

#include "vision/VisionState.h"
#include "vision/blobs/Blobs.h"

namespace kelpie::vision {
namespace {

HorizonFrame rolled(double degrees) {
  const double roll = degrees * 3.14159265358979 / 180.0;
  return {std::cos(roll), std::sin(roll), 0.0, Lens{}};
}

// A pixel of Y 8, 16, ... and no colour has the first, second, ... class; black none.
Yuv paintOf(ColourClass c) { return {static_cast<std::uint8_t>(8 * static_cast<int>(c)), 0, 0}; }

VisionCalibration plainCalibration() {
  VisionCalibration calibration{};
  calibration.ring = buildRingTable({});
  for (std::size_t c = 0; c < kColourClassCount; ++c) {
    const auto colour = static_cast<ColourClass>(c);
    calibration.colour.set(ColourTable::cellOf(paintOf(colour)), colour);
  }
  return calibration;
}

// An image of classes.
struct Canvas {
  std::unique_ptr<VisionState> state = std::make_unique<VisionState>(plainCalibration());
  std::unique_ptr<Image> image = std::make_unique<Image>();

  void box(ColourClass c, int left, int top, int right, int bottom) {
    for (int y = top; y < bottom; ++y) {
      for (int x = left; x < right; ++x) image->set(x, y, paintOf(c));
    }
  }
  // A square upright in the level image, about the middle of the image.
  void square(ColourClass c, const HorizonFrame& frame, double side) {
    for (int y = 0; y < kImageHeight; ++y) {
      for (int x = 0; x < kImageWidth; ++x) {
        const LevelPoint p = frame.fromImage({x + 0.5, y + 0.5});
        const double away = std::fmax(std::fabs(p.u - body::kNominalLens.principalX),
                                      std::fabs(p.v - body::kNominalLens.principalY));
        if (away <= 0.5 * side) box(c, x, y, x + 1, y + 1);
      }
    }
  }
  const BlobBuffer& blobs(const HorizonFrame& frame = HorizonFrame{}) {
    const Sampler sampler(*image, state->tables, state->classes);
    counts = findBlobs(sampler, Lattice(frame), state->runs, state->blobs);
    return state->blobs;
  }
  BlobCounts counts;
};

// Ring centres apart, every pixel another colour.
TEST(Blobs, SamplesOfARowHaveTheClassesThatTheyHaveOneByOne) {
  const auto state = std::make_unique<VisionState>(nominalCalibration());
  const auto image = std::make_unique<Image>();
  for (int py = 0; py < kImageHeight; ++py)
    for (int px = 0; px < kImageWidth; ++px)
      image->set(px, py,
                 {static_cast<std::uint8_t>(7 * px + py), static_cast<std::uint8_t>(80 + px / 2),
                  static_cast<std::uint8_t>(60 + py / 2)});
  Sampler sampler(*image, state->tables, state->classes);
  for (const double roll : {0.0, 3.0, -40.0}) {
    const Lattice lattice(rolled(roll));
    for (int r = 0; r < lattice.rows(); r += 5) {
      const LatticeRow row = lattice.row(r);
      std::array<std::uint8_t, 160> found{};
      sampler.reset();
      sampler.classifyRow(row.x, row.y, lattice.stepX(), lattice.stepY(), row.count, found.data());
      sampler.reset();
      for (int i = 0; i < row.count; ++i) {
        const ColourClass c = sampler.classAt((row.x + i * lattice.stepX()) >> 16,
                                              (row.y + i * lattice.stepY()) >> 16);
        ASSERT_EQ(found[static_cast<std::size_t>(i)], static_cast<std::uint8_t>(c));
      }
    }
  }
}

TEST(Blobs, PixelOfACoordinateIsItsFloor) {
  for (const double x : {-3.0, -2.7, -0.1, 0.0, 0.1, 4.0, 207.999})
    EXPECT_EQ(Sampler::pixelOf(x), static_cast<int>(std::floor(x)));
}

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
  EXPECT_GT(canvas.counts.lost, 0U);
}

TEST(Blobs, SquareUprightInTheLevelImageKeepsItsBoxWhateverTheRoll) {
  for (double roll = -80.0; roll <= 80.0; roll += 10.0) {
    const HorizonFrame frame = rolled(roll);
    Canvas canvas;
    canvas.square(ColourClass::blue, frame, 40.0);
    const auto& blobs = canvas.blobs(frame);
    ASSERT_EQ(blobs.size(), 1U) << roll;
    // A step of the lattice and the pixels' corners. Boxed along the image's axes it were 53 and
    // more from 25 deg on.
    EXPECT_NEAR(blobs[0].box.width(), 40.0, 3.0) << roll;
    EXPECT_NEAR(blobs[0].box.height(), 40.0, 3.0) << roll;
    EXPECT_NEAR(blobs[0].centre.x, body::kNominalLens.principalX, 1.0) << roll;
    EXPECT_NEAR(blobs[0].centre.y, body::kNominalLens.principalY, 1.0) << roll;
  }
}

TEST(Lattice, EverySampleIsUsableWhateverTheRoll) {
  for (double roll = -80.0; roll <= 80.0; roll += 0.25) {
    const Lattice lattice(rolled(roll));
    ASSERT_LE(lattice.rows(), 256) << roll;  // a run keeps its row in eight bits
    for (int number = 0; number < lattice.rows(); ++number) {
      const LatticeRow row = lattice.row(number);
      ASSERT_LE(row.first + row.count, 256) << roll;
      std::int32_t x = row.x;
      std::int32_t y = row.y;
      for (int i = 0; i < row.count; ++i, x += lattice.stepX(), y += lattice.stepY())
        ASSERT_TRUE(Sampler::usable(x >> 16, y >> 16)) << roll << " row " << number;
    }
  }
}

TEST(Lattice, RowsAreWholeAndCoverTheImageOnceEveryFourPixels) {
  const double pixels = (kUsableRight - kUsableLeft) * (kUsableBottom - kUsableTop);
  for (double roll = -80.0; roll <= 80.0; roll += 0.25) {
    const Lattice lattice(rolled(roll));
    int samples = 0;
    for (int number = 0; number < lattice.rows(); ++number) samples += lattice.row(number).count;
    // A row may end anywhere within a step of the image's border: 2 % of the samples.
    EXPECT_NEAR(samples, pixels / 4.0, 0.02 * pixels / 4.0) << roll;
  }
}

TEST(Lattice, SamplesLieWhereTheirLevelCoordinatesSay) {
  for (double roll = -80.0; roll <= 80.0; roll += 5.0) {
    const Lattice lattice(rolled(roll));
    for (int number = 0; number < lattice.rows(); number += 7) {
      const LatticeRow row = lattice.row(number);
      if (row.count == 0) continue;
      const int last = row.count - 1;
      const PixelPoint p =
          lattice.frame().toImage({lattice.u(row.first + last), lattice.v(number)});
      // 127 steps rounded to 1/65536 px.
      EXPECT_NEAR((row.x + last * lattice.stepX()) / 65536.0, p.x, 0.002) << roll;
      EXPECT_NEAR((row.y + last * lattice.stepY()) / 65536.0, p.y, 0.002) << roll;
    }
  }
}

}  // namespace
}  // namespace kelpie::vision
