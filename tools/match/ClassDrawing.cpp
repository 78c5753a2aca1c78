// SPDX-License-Identifier: Apache-2.0
#include "tools/match/ClassDrawing.h"

#include <memory>

#include "vision/pixels/ClassPicture.h"

namespace kelpie::match {

cv::Vec3b inkOfClass(std::uint8_t number) {
  const vision::Rgb c = vision::kColourPalette[number];
  return {c.b, c.g, c.r};
}

cv::Mat drawClasses(const Image& image, const vision::PixelTables& tables) {
  const auto plane = std::make_unique<vision::ClassPlane>();
  vision::classifyWhole(image, tables, *plane);
  cv::Mat picture(kImageHeight, kImageWidth, CV_8UC3);
  for (std::size_t i = 0; i < plane->size(); ++i)
    picture.ptr<cv::Vec3b>()[i] = inkOfClass((*plane)[i]);
  return picture;
}

}  // namespace kelpie::match
