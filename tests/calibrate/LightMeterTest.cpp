// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "robot/core/Maths.h"
#include "robot/core/Random.h"
#include "tools/calibrate/light/LightMeter.h"

namespace kelpie::calibrate {
namespace {

using agent::CameraGain;
using agent::CameraSettings;
using agent::Shutter;
using agent::WhiteBalance;
using vision::SurfaceColour;

const vision::LightParams kNominal;

std::uint8_t byteOf(double value) {
  return static_cast<std::uint8_t>(maths::clamp(value + 0.5, 0.0, 255.0));
}

// Under a grey wall a carpet with lines that are five rows wide; noise of 2 levels.
Image fieldImage(double gain, const SurfaceColour& line, double wall = 60.0) {
  Random random(3);
  Image image;
  for (int py = 0; py < kImageHeight; ++py) {
    const bool isLine = py > 60 && py % 40 < 5;
    const SurfaceColour below = isLine ? line : kNominal.carpet;
    const SurfaceColour paint = py < 40 ? SurfaceColour{wall, 128, 128} : below;
    for (int px = 0; px < kImageWidth; ++px)
      image.set(px, py,
                {byteOf(gain * paint.y + random.gaussian(0, 2)),
                 byteOf(128.0 + gain * (paint.cr - 128.0) + random.gaussian(0, 2)),
                 byteOf(128.0 + gain * (paint.cb - 128.0) + random.gaussian(0, 2))});
  }
  return image;
}

LightMeasure measured(const Image& image) {
  const vision::RingTable ring = vision::buildRingTable({});
  LightMeter meter(ring, kNominal.carpet);
  meter.add(image);
  meter.add(image);
  return meter.measure();
}

TEST(LightMeter, SeesWhatCarpetAndLinesArePaintedWith) {
  const LightMeasure m = measured(fieldImage(1.0, kNominal.line));
  EXPECT_EQ(m.images, 2U);
  ASSERT_TRUE(m.carpet && m.line);
  EXPECT_NEAR(m.carpet->y, 77.0, 1.0);
  EXPECT_NEAR(m.carpet->cr, 103.0, 1.0);
  EXPECT_NEAR(m.carpet->cb, 97.0, 1.0);
  EXPECT_NEAR(m.line->y, 189.0, 4.0);  // the brightest of five rows
  EXPECT_NEAR(m.line->cr, 124.0, 2.0);
  EXPECT_NEAR(m.line->cb, 129.0, 2.0);
}

TEST(LightMeter, CountsWhatIsCutOffAtEitherEnd) {
  Image image;
  image.y.fill(128);
  for (int px = 0; px < kImageWidth; ++px) {
    for (int py = 0; py < kImageHeight / 2; ++py) image.y[Image::at(px, py)] = 250;
    for (int py = 120; py < kImageHeight; ++py) image.y[Image::at(px, py)] = 5;
  }
  const LightMeasure m = measured(image);
  EXPECT_NEAR(m.bright, 0.5, 0.01);
  EXPECT_NEAR(m.dark, 0.25, 0.01);
}

TEST(LightMeter, WithoutCarpetThereIsNoLineEither) {
  Image image;
  image.y.fill(100);
  image.cr.fill(128);
  image.cb.fill(128);
  const LightMeasure m = measured(image);
  EXPECT_FALSE(m.carpet || m.line);
  EXPECT_NEAR(m.brightness, 100.0, 1e-9);
}

TEST(LightVerdict, TheNominalLightIsRight) {
  const CameraSettings set;
  const LightVerdict verdict = verdictOn(measured(fieldImage(1.0, kNominal.line)), set);
  EXPECT_EQ(verdict.fault, LightFault::none);
  EXPECT_EQ(verdict.next, set);
}

TEST(LightVerdict, DarkImagesAskForGainFirstAndThenForASlowerShutter) {
  const LightMeasure dark = measured(fieldImage(0.4, kNominal.line));
  CameraSettings set{WhiteBalance::fluorescent, CameraGain::mid, Shutter::fast};
  set = verdictOn(dark, set).next;
  EXPECT_EQ(set, (CameraSettings{WhiteBalance::fluorescent, CameraGain::high, Shutter::fast}));
  set = verdictOn(dark, set).next;
  EXPECT_EQ(set, (CameraSettings{WhiteBalance::fluorescent, CameraGain::high, Shutter::mid}));
  set.shutter = Shutter::slow;
  EXPECT_EQ(verdictOn(dark, set).fault, LightFault::tooDark);
  EXPECT_EQ(verdictOn(dark, set).next, set) << "nothing is left to set";
}

TEST(LightVerdict, BrightImagesAskForAFasterShutterFirstAndThenForLessGain) {
  const LightMeasure bright = measured(fieldImage(1.0, kNominal.line, 255.0));
  CameraSettings set{WhiteBalance::fluorescent, CameraGain::high, Shutter::mid};
  EXPECT_EQ(verdictOn(bright, set).fault, LightFault::tooBright);
  set = verdictOn(bright, set).next;
  EXPECT_EQ(set, CameraSettings{});
  EXPECT_EQ(verdictOn(bright, set).next.gain, CameraGain::mid);
}

struct Balance {
  SurfaceColour line;
  WhiteBalance set;
  WhiteBalance next;
};

// By Planck's law, light of one temperature in a camera set for another.
TEST(LightVerdict, WhiteThatIsNotNeutralAsksForTheBalanceOfItsLight) {
  const SurfaceColour warm{180, 175, 73};
  const SurfaceColour warmer{180, 142, 108};
  const SurfaceColour cold{180, 114, 152};
  const SurfaceColour coldest{180, 85, 226};
  const SurfaceColour white{180, 128, 128};
  for (const Balance& b : {Balance{warm, WhiteBalance::fluorescent, WhiteBalance::indoor},
                           Balance{warmer, WhiteBalance::outdoor, WhiteBalance::fluorescent},
                           Balance{cold, WhiteBalance::fluorescent, WhiteBalance::outdoor},
                           Balance{coldest, WhiteBalance::indoor, WhiteBalance::fluorescent},
                           Balance{white, WhiteBalance::indoor, WhiteBalance::indoor},
                           Balance{white, WhiteBalance::outdoor, WhiteBalance::outdoor},
                           Balance{warmer, WhiteBalance::fluorescent, WhiteBalance::fluorescent}}) {
    LightMeasure m = measured(fieldImage(1.0, kNominal.line));
    m.line = b.line;
    EXPECT_EQ(verdictOn(m, {b.set}).next.whiteBalance, b.next) << b.line.cr;
  }
}

TEST(LightMeter, LogsThatAreNotThereAreOneLine) {
  EXPECT_EQ(readLight("no/such.mcap").error().find("no/such.mcap: "), 0U);
}

}  // namespace
}  // namespace kelpie::calibrate
