// SPDX-License-Identifier: Apache-2.0
#include "tools/picture/PngFile.h"

#include <png.h>

#include <cstdio>

namespace kelpie::picture {
namespace {

png_image header(const cv::Size& size) {
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  png.width = static_cast<png_uint_32>(size.width);
  png.height = static_cast<png_uint_32>(size.height);
  png.format = PNG_FORMAT_BGR;
  return png;
}

}  // namespace

Status writePng(const std::string& path, const cv::Mat& picture) {
  const cv::Mat rows = picture.isContinuous() ? picture : picture.clone();
  png_image png = header(rows.size());
  const std::string part = path + ".part";
  if (rows.type() == CV_8UC3 &&
      png_image_write_to_file(&png, part.c_str(), 0, rows.data, 0, nullptr) != 0 &&
      std::rename(part.c_str(), path.c_str()) == 0)
    return Done{};
  std::remove(part.c_str());
  return Error{path + ": cannot be written"};
}

Expected<cv::Mat> readPng(const std::string& path) {
  png_image png = header({});
  if (png_image_begin_read_from_file(&png, path.c_str()) == 0)
    return Error{path + ": not a picture that can be read"};
  constexpr png_uint_32 kLargest = 20000;  // pixels a side: more is no picture of ours
  if (png.width > kLargest || png.height > kLargest) {
    png_image_free(&png);
    return Error{path + ": not a picture that can be read"};
  }
  png.format = PNG_FORMAT_BGR;
  cv::Mat picture(static_cast<int>(png.height), static_cast<int>(png.width), CV_8UC3);
  const png_color black{};
  if (png_image_finish_read(&png, &black, picture.data, 0, nullptr) == 0)
    return Error{path + ": not a picture that can be read"};
  return picture;
}

}  // namespace kelpie::picture
