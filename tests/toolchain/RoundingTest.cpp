// SPDX-License-Identifier: Apache-2.0
// The object's own rounding against glibc's. test_object.py does the same in the emulated image.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <vector>

#include "toolchain/openr/Rounding.h"

namespace kelpie::openr {
namespace {

std::uint64_t bitsOf(double x) {
  std::uint64_t bits = 0;
  std::memcpy(&bits, &x, sizeof bits);
  return bits;
}

// Places where rounding goes wrong: zeros, halves, their neighbours, and from 2^20 to 2^21, where
// the C library of the SDK has lround wrong.
std::vector<double> edgeValues() {
  std::vector<double> values = {0.0,       0.5,       1.0,       1.5,          2.5,
                                1e-310,    1048576.0, 1048576.5, 1572863.5,    2097151.5,
                                2097152.0, 1e9 + 0.5, 2e9,       2147483646.5, 0.3};
  for (double x = 1048576.0; x < 2097152.0; x += 1021.0625) values.push_back(x);
  const std::size_t count = values.size();
  for (std::size_t i = 0; i < count; ++i) {
    values.push_back(std::nextafter(values[i], 1e300));
    values.push_back(std::nextafter(values[i], -1e300));
  }
  const std::size_t positive = values.size();
  for (std::size_t i = 0; i < positive; ++i) values.push_back(-values[i]);
  return values;
}

TEST(Rounding, HasTheBitsOfGlibcAtItsEdges) {
  for (const double x : edgeValues()) {
    EXPECT_EQ(bitsOf(floorOf(x)), bitsOf(std::floor(x))) << x;
    EXPECT_EQ(bitsOf(ceilOf(x)), bitsOf(std::ceil(x))) << x;
    EXPECT_EQ(lroundOf(x), std::lround(x)) << x;
  }
}

TEST(Rounding, ZerosKeepTheirSign) {
  EXPECT_TRUE(std::signbit(floorOf(-0.0)));
  EXPECT_TRUE(std::signbit(ceilOf(-0.5)));
  EXPECT_FALSE(std::signbit(floorOf(0.5)));
}

TEST(Rounding, WhatHasNoFractionIsLeftAsItIs) {
  for (const double x :
       {4503599627370496.0, -9007199254740993.0, 1e300, std::numeric_limits<double>::infinity(),
        -std::numeric_limits<double>::infinity()}) {
    EXPECT_EQ(bitsOf(floorOf(x)), bitsOf(x));
    EXPECT_EQ(bitsOf(ceilOf(x)), bitsOf(x));
  }
  EXPECT_TRUE(std::isnan(floorOf(std::nan(""))));
}

TEST(Rounding, LeadingZerosAreTheCompilers) {
  for (std::uint32_t bit = 1; bit != 0; bit <<= 1) {
    EXPECT_EQ(leadingZeros(bit), __builtin_clz(bit));
    EXPECT_EQ(leadingZeros(bit | 1U), __builtin_clz(bit | 1U));
  }
}

}  // namespace
}  // namespace kelpie::openr
