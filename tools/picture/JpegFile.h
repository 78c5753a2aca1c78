// SPDX-License-Identifier: Apache-2.0
// JPEG files by libturbojpeg, for drawings of any size. They appear whole or not at all.
#pragma once

#include <opencv2/core.hpp>
#include <string>

#include "robot/core/Expected.h"

namespace kelpie::picture {

// 8 bits a channel, blue green red.
Status writeJpeg(const std::string& path, const cv::Mat& picture);

}  // namespace kelpie::picture
