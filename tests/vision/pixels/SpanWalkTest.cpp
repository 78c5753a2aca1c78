// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <memory>

#include "tests/vision/Painting.h"
#include "vision/VisionState.h"
#include "vision/pixels/SpanWalk.h"

namespace kelpie::vision {
namespace {

// Yellow left of an upright edge at x, green right of it; the pixel that it crosses is mixed.
struct Edge {
  std::unique_ptr<VisionState> state = stateForPaintings();
  std::unique_ptr<Image> image = std::make_unique<Image>();

  explicit Edge(double x) {
    state->tables.ring = RingByValue(buildRingTable({}));
    for (int py = 0; py < kImageHeight; ++py) {
      for (int px = 0; px < kImageWidth; ++px)
        image->set(px, py, mixed(maths::clamp(x - px, 0.0, 1.0)));
    }
  }
  static Yuv mixed(double yellow) {
    const auto mix = [yellow](double a, double b) {
      return static_cast<std::uint8_t>(yellow * a + (1.0 - yellow) * b + 0.5);
    };
    return {mix(kYellowPaint.y, kGreenPaint.y), mix(kYellowPaint.cr, kGreenPaint.cr),
            mix(kYellowPaint.cb, kGreenPaint.cb)};
  }
  EdgeHit walk(PixelPoint from, double dx, double dy) const {
    const Sampler sampler(*image, state->tables, state->classes);
    return walkToEdge(sampler, {from, {dx, dy}, ColourClass::yellow, 1});
  }
};

TEST(SpanWalk, EdgeIsPlacedWithinATenthOfAPixel) {
  for (const double x : {80.0, 80.25, 80.5, 80.75, 81.1}) {
    const EdgeHit hit = Edge(x).walk({60.5, 70.5}, 1, 0);
    EXPECT_FALSE(hit.cut);
    EXPECT_NEAR(hit.point.x, x, 0.1);
    EXPECT_NEAR(hit.length, x - 60.5, 0.1);
  }
}

TEST(SpanWalk, SlantingWalkMeetsTheSameEdge) {
  EXPECT_NEAR(Edge(90.3).walk({70.5, 60.5}, 0.8, 0.6).point.x, 90.3, 0.3);
}

TEST(SpanWalk, BorderOfTheImageCutsThePatch) {
  const EdgeHit hit = Edge(80).walk({60.5, 70.5}, -1, 0);
  EXPECT_TRUE(hit.cut);
  EXPECT_NEAR(hit.point.x, kUsableLeft + 0.5, 0.01);
}

}  // namespace
}  // namespace kelpie::vision
