// SPDX-License-Identifier: Apache-2.0
// What a pixel's colour can mean. Sixteen values at most: the colour table keeps four bits each.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace kelpie::vision {

enum class ColourClass : std::uint8_t {
  none,
  orange,
  blue,
  yellow,
  pink,
  robotBlue,
  robotRed,
  green,
  grey,
  white,
  black,
};
constexpr std::size_t kColourClassCount = 11;
constexpr std::size_t index(ColourClass c) { return static_cast<std::size_t>(c); }

constexpr std::array<const char*, kColourClassCount> kColourNames = {
    "none",     "orange", "blue", "yellow", "pink", "robotBlue",
    "robotRed", "green",  "grey", "white",  "black"};

struct Rgb {
  std::uint8_t r;
  std::uint8_t g;
  std::uint8_t b;
};

// How viewers draw each class.
constexpr std::array<Rgb, kColourClassCount> kColourPalette = {{{70, 70, 90},
                                                                {255, 128, 0},
                                                                {0, 160, 255},
                                                                {255, 230, 0},
                                                                {255, 105, 200},
                                                                {0, 0, 160},
                                                                {200, 0, 0},
                                                                {0, 150, 40},
                                                                {140, 140, 140},
                                                                {255, 255, 255},
                                                                {0, 0, 0}}};

}  // namespace kelpie::vision
