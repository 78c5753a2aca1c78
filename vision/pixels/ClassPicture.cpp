// SPDX-License-Identifier: Apache-2.0
#include "vision/pixels/ClassPicture.h"

#include <memory>

namespace kelpie::vision {

std::size_t classifyWhole(const Image& image, const PixelTables& tables, ClassPlane& plane) {
  const auto classes = std::make_unique<ClassMemory>();
  const Sampler sampler(image, tables, *classes);
  std::size_t known = 0;
  for (int py = 0; py < kImageHeight; ++py) {
    for (int px = 0; px < kImageWidth; ++px) {
      const ColourClass colour = sampler.classAt(px, py);
      plane[Image::at(px, py)] = static_cast<std::uint8_t>(colour);
      if (colour != ColourClass::none) ++known;
    }
  }
  return known;
}

std::size_t classifyWhole(const Image& image, const VisionCalibration& calibration,
                          ClassPlane& plane) {
  return classifyWhole(image, *std::make_unique<PixelTables>(calibration), plane);
}

}  // namespace kelpie::vision
