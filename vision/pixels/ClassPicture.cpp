// SPDX-License-Identifier: Apache-2.0
#include "vision/pixels/ClassPicture.h"

namespace kelpie::vision {

std::size_t classifyWhole(const Image& image, const VisionCalibration& calibration,
                          ClassPlane& plane) {
  const RingDistances distances;
  plane.fill(kNotLookedAt);
  const Sampler sampler(image, calibration, distances, plane);
  std::size_t known = 0;
  for (int py = 0; py < kImageHeight; ++py) {
    for (int px = 0; px < kImageWidth; ++px) {
      if (sampler.classAt(px, py) != ColourClass::none) ++known;
    }
  }
  return known;
}

}  // namespace kelpie::vision
