// SPDX-License-Identifier: Apache-2.0
#include "vision/Sampler.h"

namespace kelpie::vision {

std::uint32_t Sampler::sampleLattice() {
  classes_.fill(kNotLookedAt);
  for (int row = 0; row < kLatticeRows; ++row) {
    const int py = kLatticeTop + row * kLatticeStep;
    const std::uint8_t* distances = distances_.row(py);
    for (int column = 0; column < kLatticeColumns; ++column) {
      const int px = kLatticeLeft + column * kLatticeStep;
      const std::size_t distance = distances[RingDistances::column(px)];
      const Yuv corrected = calibration_.ring(image_.pixel(px, py), distance);
      classes_[Image::at(px, py)] = static_cast<std::uint8_t>(calibration_.colour(corrected));
    }
  }
  return static_cast<std::uint32_t>(kLatticeRows * kLatticeColumns);
}

}  // namespace kelpie::vision
