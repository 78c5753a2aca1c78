// SPDX-License-Identifier: Apache-2.0
#include "tools/picture/CameraPicture.h"

#include <array>
#include <opencv2/imgproc.hpp>

namespace kelpie::picture {
namespace {

cv::Mat header(const Image::Plane& plane) {
  return {kImageHeight, kImageWidth, CV_8UC1, const_cast<std::uint8_t*>(plane.data())};
}

}  // namespace

cv::Mat pictureOf(const Image& image) {
  const std::array<cv::Mat, 3> planes = {header(image.y), header(image.cr), header(image.cb)};
  cv::Mat joined;
  cv::merge(planes.data(), planes.size(), joined);
  cv::Mat picture;
  cv::cvtColor(joined, picture, cv::COLOR_YCrCb2BGR);
  return picture;
}

Image imageOf(const cv::Mat& picture) {
  cv::Mat joined;
  cv::cvtColor(picture, joined, cv::COLOR_BGR2YCrCb);
  Image image;
  std::array<cv::Mat, 3> planes = {header(image.y), header(image.cr), header(image.cb)};
  cv::split(joined, planes.data());
  return image;
}

}  // namespace kelpie::picture
