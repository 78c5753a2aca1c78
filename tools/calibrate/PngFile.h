// SPDX-License-Identifier: Apache-2.0
// PNG files that appear whole or not at all. OpenCV's own writer prints its complaints to standard
// error and leaves half a file on a full disk.
#pragma once

#include <opencv2/core.hpp>
#include <string>

#include "robot/core/Expected.h"

namespace kelpie::calibrate {

// 8 bits a channel, blue green red. Another name is written first and moved in place.
Status writePng(const std::string& path, const cv::Mat& picture);

}  // namespace kelpie::calibrate
