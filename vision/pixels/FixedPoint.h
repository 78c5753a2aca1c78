// SPDX-License-Identifier: Apache-2.0
// Places in the image as whole numbers of a small part of a pixel.
#pragma once

#include <cstdint>

namespace kelpie::vision {

// The lattice's positions: 1/65536 px, so that what the shift leaves is the pixel.
constexpr int kLatticeBits = 16;
constexpr double kLatticeOne = 65536.0;

// To the nearest of `one` parts of a pixel, without the library's call: two for each row.
inline std::int32_t fixedPoint(double value, double one) {
  const double scaled = value * one;
  return static_cast<std::int32_t>(scaled < 0.0 ? scaled - 0.5 : scaled + 0.5);
}

}  // namespace kelpie::vision
