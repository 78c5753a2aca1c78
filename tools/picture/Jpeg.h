// SPDX-License-Identifier: Apache-2.0
// Camera images as JPEG pictures for people, by libturbojpeg, with colours at half the resolution.
// Lost: the noise and what is finer than two pixels in colour; vision on such a picture sees almost
// the same, not the same.
#pragma once

#include <cstdint>
#include <vector>

#include "robot/core/types/Image.h"

namespace kelpie::picture {

// quality: 1 to 100. Empty when the library fails (no memory).
std::vector<std::uint8_t> jpegOf(const Image& image, int quality);

// False when the bytes are no JPEG of 208 x 160 pixels; `image` is then of no use.
bool imageOfJpeg(const std::uint8_t* bytes, std::size_t size, Image& image);

}  // namespace kelpie::picture
