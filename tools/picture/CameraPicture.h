// SPDX-License-Identifier: Apache-2.0
// A camera image in colours that a screen shows, and back (ITU-R BT.601 at full range, as the
// ERS-7's camera gives it).
#pragma once

#include <opencv2/core.hpp>

#include "robot/core/types/Image.h"

namespace kelpie::picture {

// 160 rows, 208 columns, blue green red.
cv::Mat pictureOf(const Image& image);
// `picture` must have just that size and type.
Image imageOf(const cv::Mat& picture);

}  // namespace kelpie::picture
