// SPDX-License-Identifier: Apache-2.0
// PNG files by libpng. They appear whole or not at all: another name is written first and moved in
// place.
#pragma once

#include <opencv2/core.hpp>
#include <string>
#include <vector>

#include "robot/core/Expected.h"

namespace kelpie::picture {

// 8 bits a channel, blue green red.
Status writePng(const std::string& path, const cv::Mat& picture);

// The same in the 256 colours that suit it best: a third of the size, for pictures that are kept
// with a text. The same picture gives the same file.
Status writeSmallPng(const std::string& path, const cv::Mat& picture);

// Numbers into a palette of at most 256 colours, which are blue green red. The same picture gives
// the same file.
Status writeIndexedPng(const std::string& path, const cv::Mat& numbers,
                       const std::vector<cv::Vec3b>& palette);

// As blue green red, whatever the file has; what is transparent is laid on black.
Expected<cv::Mat> readPng(const std::string& path);

}  // namespace kelpie::picture
