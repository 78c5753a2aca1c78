// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <memory>

#include "robot/core/Random.h"
#include "vision/pixels/ClassMemory.h"
#include "vision/pixels/PixelTables.h"

namespace kelpie::vision {
namespace {

TEST(RingByValue, CorrectsEveryValueAtEveryDistanceAsTheRingTableDoes) {
  const auto table = std::make_unique<RingTable>(buildRingTable(ringModelNominal()));
  const auto turned = std::make_unique<RingByValue>(*table);
  for (std::size_t d = 0; d < kRingDistances; ++d) {
    for (unsigned value = 0; value < 256; ++value) {
      const auto at = static_cast<std::uint8_t>(d);
      const auto v = static_cast<std::uint8_t>(value);
      const Yuv one = (*table)({v, v, v}, {at, at, at});
      const Yuv other = (*turned)({v, v, v}, {at, at, at});
      ASSERT_TRUE(one.y == other.y && one.cr == other.cr && one.cb == other.cb) << d << " " << v;
    }
  }
}

TEST(ClassMemory, KnowsThePixelsOfThisImageAloneOverManyImages) {
  const auto memory = std::make_unique<ClassMemory>();
  Random random(7);
  for (int image = 0; image < 50; ++image) {
    if (image > 0) memory->forget();
    for (std::size_t i = 0; i < kImagePixels; i += 11)
      ASSERT_EQ(memory->looked(i), kNotLookedAt) << image;
    std::array<unsigned, 40> classes{};
    for (std::size_t k = 0; k < classes.size(); ++k) {
      classes[k] = random.index(kColourClassCount);
      memory->keep(11 * k, classes[k]);
    }
    for (std::size_t k = 0; k < classes.size(); ++k) {
      ASSERT_TRUE(ClassMemory::knows(memory->at(11 * k)));
      ASSERT_EQ(memory->looked(11 * k), classes[k]);
      ASSERT_EQ(memory->looked(11 * k + 1), kNotLookedAt);
    }
  }
}

}  // namespace
}  // namespace kelpie::vision
