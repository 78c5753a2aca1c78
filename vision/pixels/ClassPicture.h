// SPDX-License-Identifier: Apache-2.0
// The whole image's classes at full resolution, for viewers and tests; the frame loop classifies
// the lattice only.
#pragma once

#include <array>
#include <cstdint>

#include "vision/colour/VisionCalibration.h"
#include "vision/pixels/Sampler.h"

namespace kelpie::vision {

// Fills the plane with ColourClass numbers (draw them with kColourPalette); the number of pixels
// that have a class other than none.
std::size_t classifyWhole(const Image& image, const PixelTables& tables, ClassPlane& plane);
std::size_t classifyWhole(const Image& image, const VisionCalibration& calibration,
                          ClassPlane& plane);

}  // namespace kelpie::vision
