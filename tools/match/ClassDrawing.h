// SPDX-License-Identifier: Apache-2.0
// Colour classes as pictures, each class in the colour that people know it by.
#pragma once

#include <cstdint>
#include <opencv2/core.hpp>

#include "robot/core/types/FrameInput.h"
#include "vision/pixels/PixelTables.h"

namespace kelpie::match {

cv::Vec3b inkOfClass(std::uint8_t number);  // blue green red
// The class of every pixel, by the colour table; as large as the image.
cv::Mat drawClasses(const Image& image, const vision::PixelTables& tables);

}  // namespace kelpie::match
