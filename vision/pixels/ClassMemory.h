// SPDX-License-Identifier: Apache-2.0
// The classes of the pixels that were looked at in this image. A cell holds the image's number, one
// of fifteen, beside the class, so that a new image is begun without a write to each cell: those
// were a tenth of the second-level cache's misses.
#pragma once

#include <array>
#include <cstdint>

#include "robot/core/types/Image.h"
#include "vision/colour/ColourClass.h"

namespace kelpie::vision {

using ClassPlane = std::array<std::uint8_t, kImagePixels>;
constexpr std::uint8_t kNotLookedAt = 255;

class ClassMemory {
 public:
  ClassMemory() { cells_.fill(kNever); }

  // Forgets the last image. Once in fifteen images all cells are written.
  void forget() {
    image_ = static_cast<std::uint8_t>(image_ + kClasses);
    if (image_ != (kNever & kImageBits)) return;
    cells_.fill(kNever);
    image_ = 0;
  }

  // The class, or some number that knows() refuses.
  unsigned at(std::size_t pixel) const {
    return cells_[pixel] ^ unsigned { image_ };
  }
  static bool knows(unsigned at) { return at < kClasses; }
  void keep(std::size_t pixel, unsigned colour) {
    cells_[pixel] = static_cast<std::uint8_t>(colour ^ image_);
  }
  // For many pixels: where they are kept, and what a class is combined with there.
  std::uint8_t* cells() { return cells_.data(); }
  std::uint8_t image() const { return image_; }

  // The class or kNotLookedAt.
  std::uint8_t looked(std::size_t pixel) const {
    const unsigned colour = at(pixel);
    return knows(colour) ? static_cast<std::uint8_t>(colour) : kNotLookedAt;
  }

 private:
  static constexpr unsigned kClasses = 16;
  static constexpr std::uint8_t kImageBits = 0xF0;
  static constexpr std::uint8_t kNever = 0xFF;
  static_assert(kColourClassCount <= kClasses);

  ClassPlane cells_;
  std::uint8_t image_ = 0;  // in the upper four bits
};

}  // namespace kelpie::vision
