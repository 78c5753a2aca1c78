// SPDX-License-Identifier: Apache-2.0
// One image as the finders read it: ring-corrected values and colour classes. A pixel is corrected
// and classified at most once a frame; its class is kept in the plane of VisionState.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>

#include "robot/core/Geometry.h"
#include "robot/core/Image.h"
#include "vision/RingTable.h"
#include "vision/VisionCalibration.h"

namespace kelpie::vision {

using ClassPlane = std::array<std::uint8_t, kImagePixels>;
constexpr std::uint8_t kNotLookedAt = 255;

// The ERS-7's outermost three pixels are unusable (facts-2005 section 4.1).
constexpr int kRim = 3;
constexpr int kUsableLeft = kRim;
constexpr int kUsableTop = kRim;
constexpr int kUsableRight = kImageWidth - kRim;  // first column beyond
constexpr int kUsableBottom = kImageHeight - kRim;

class Sampler {
 public:
  Sampler(const Image& image, const VisionCalibration& calibration, const RingDistances& distances,
          ClassPlane& classes)
      : image_(image), calibration_(calibration), distances_(distances), classes_(classes) {}

  static bool usable(int px, int py) {
    return px >= kUsableLeft && px < kUsableRight && py >= kUsableTop && py < kUsableBottom;
  }
  static bool usable(PixelPoint p) { return usable(pixelOf(p.x), pixelOf(p.y)); }
  static int pixelOf(double coordinate) { return static_cast<int>(std::floor(coordinate)); }

  Yuv corrected(int px, int py) const {
    return calibration_.ring(image_.pixel(px, py), distances_(px, py, calibration_.ring.centre));
  }
  ColourClass classOf(Yuv corrected) const { return calibration_.colour(corrected); }
  ColourClass classAt(int px, int py) const {
    std::uint8_t& known = classes_[Image::at(px, py)];
    if (known == kNotLookedAt) {
      known = static_cast<std::uint8_t>(calibration_.colour(corrected(px, py)));
    }
    return static_cast<ColourClass>(known);
  }
  ColourClass classAt(PixelPoint p) const { return classAt(pixelOf(p.x), pixelOf(p.y)); }
  // As measured: for differences between neighbours, which the ring correction hardly changes.
  Yuv raw(int px, int py) const { return image_.pixel(px, py); }
  std::uint8_t rawY(int px, int py) const { return image_.y[Image::at(px, py)]; }
  const Image::Plane& rawY() const { return image_.y; }

  // Forgets the last image.
  void reset() { classes_.fill(kNotLookedAt); }

 private:
  const Image& image_;
  const VisionCalibration& calibration_;
  const RingDistances& distances_;
  ClassPlane& classes_;
};

}  // namespace kelpie::vision
