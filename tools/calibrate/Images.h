// SPDX-License-Identifier: Apache-2.0
// Camera images from files, for calibration and import: .png (RGB), .yuv (planes Y, Cr, Cb), .bin
// (rows of Y, Cr, Cb, as the genuine ERS-7 frames are kept), or the images of a log. Each must be
// 208 x 160; anything else is one line that names the file.
#pragma once

#include <string>
#include <vector>

#include "robot/core/Expected.h"
#include "robot/core/types/Image.h"

namespace kelpie::calibrate {

struct NamedImage {
  std::string name;  // file, or log and frame
  Image image;
};

Expected<Image> readImage(const std::string& path);
// All images of a folder in the order of their names, or at most `max` of a log, evenly spread.
Expected<std::vector<NamedImage>> readImages(const std::string& path, std::size_t max);
Status writePicture(const Image& image, const std::string& path);

}  // namespace kelpie::calibrate
