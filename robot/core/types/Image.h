// SPDX-License-Identifier: Apache-2.0
// One camera image: three full planes Y, Cr, Cb of 208 x 160 bytes, row by row from the top left.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "robot/core/fields/Fields.h"

namespace kelpie {

constexpr int kImageWidth = 208;
constexpr int kImageHeight = 160;
constexpr std::size_t kImagePixels = static_cast<std::size_t>(kImageWidth) * kImageHeight;

struct Yuv {
  std::uint8_t y = 0;
  std::uint8_t cr = 0;
  std::uint8_t cb = 0;
};

struct Image {
  using Plane = std::array<std::uint8_t, kImagePixels>;
  Plane y{};
  Plane cr{};
  Plane cb{};

  static std::size_t at(int px, int py) {
    return static_cast<std::size_t>(py) * kImageWidth + static_cast<std::size_t>(px);
  }
  Yuv pixel(int px, int py) const { return {y[at(px, py)], cr[at(px, py)], cb[at(px, py)]}; }
  void set(int px, int py, Yuv value) {
    y[at(px, py)] = value.y;
    cr[at(px, py)] = value.cr;
    cb[at(px, py)] = value.cb;
  }
  template <int = 0>
  static constexpr auto fields() {
    return fieldList(field("y", &Image::y), field("cr", &Image::cr), field("cb", &Image::cb));
  }
};

}  // namespace kelpie
