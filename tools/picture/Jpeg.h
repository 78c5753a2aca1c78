// SPDX-License-Identifier: Apache-2.0
// Camera images as JPEG, by libturbojpeg: the planes go in and come out as they are (Y, Cb, Cr at
// full resolution), without a way through red, green and blue. Lost: the noise, and steps of a few
// levels; vision on such an image sees almost the same, not the same.
#pragma once

#include <cstdint>
#include <vector>

#include "robot/core/Image.h"

namespace kelpie::picture {

// quality: 1 to 100. Empty when the library fails (no memory).
std::vector<std::uint8_t> jpegOf(const Image& image, int quality);

// False when the bytes are no JPEG of 208 x 160 pixels with three planes; `image` is then of no
// use.
bool imageOfJpeg(const std::uint8_t* bytes, std::size_t size, Image& image);

}  // namespace kelpie::picture
