// SPDX-License-Identifier: Apache-2.0
#include "vision/Sampler.h"

namespace kelpie::vision {

std::uint32_t Sampler::sampleLattice() {
  classes_.fill(kNotLookedAt);
  for (int row = 0; row < kLatticeRows; ++row) {
    const int py = kLatticeTop + row * kLatticeStep;
    const auto& centre = calibration_.ring.centre;
    const std::uint8_t* toY = distances_.row(py, centre[0]);
    const std::uint8_t* toCr = distances_.row(py, centre[1]);
    const std::uint8_t* toCb = distances_.row(py, centre[2]);
    for (int column = 0; column < kLatticeColumns; ++column) {
      const int px = kLatticeLeft + column * kLatticeStep;
      const RingPlace place{toY[px], toCr[px], toCb[px]};
      const Yuv corrected = calibration_.ring(image_.pixel(px, py), place);
      classes_[Image::at(px, py)] = static_cast<std::uint8_t>(calibration_.colour(corrected));
    }
  }
  return static_cast<std::uint32_t>(kLatticeRows * kLatticeColumns);
}

}  // namespace kelpie::vision
