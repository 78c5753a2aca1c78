// SPDX-License-Identifier: Apache-2.0
#include "tools/picture/PngFile.h"

#include <png.h>

#include <algorithm>
#include <cstdio>
#include <vector>

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

constexpr int kColours = 256;
constexpr int kSamples = 12000;  // pixels that the colours are chosen by
constexpr int kBits = 6;         // of each channel, by which the nearest colour is looked up

// Their middles, rounded, as blue green red.
std::vector<cv::Vec3b> coloursOf(const cv::Mat& picture) {
  const int every = std::max(1, static_cast<int>(picture.total()) / kSamples);
  cv::Mat samples;
  for (int i = 0; i < static_cast<int>(picture.total()); i += every) {
    const cv::Vec3b& pixel = picture.at<cv::Vec3b>(i / picture.cols, i % picture.cols);
    samples.push_back(cv::Vec3f(pixel[0], pixel[1], pixel[2]));
  }
  samples = samples.reshape(1);
  cv::Mat labels, middles;
  cv::setRNGSeed(1);
  cv::kmeans(samples, std::min(kColours, samples.rows), labels,
             cv::TermCriteria(cv::TermCriteria::COUNT, 6, 0), 1, cv::KMEANS_PP_CENTERS, middles);
  std::vector<cv::Vec3b> colours;
  for (int i = 0; i < middles.rows; ++i) {
    const auto* middle = middles.ptr<float>(i);
    colours.emplace_back(cv::saturate_cast<std::uint8_t>(middle[0]),
                         cv::saturate_cast<std::uint8_t>(middle[1]),
                         cv::saturate_cast<std::uint8_t>(middle[2]));
  }
  return colours;
}

std::uint8_t nearest(const cv::Vec3b& pixel, const std::vector<cv::Vec3b>& colours) {
  int best = 0;
  int least = 1 << 30;
  for (int i = 0; i < static_cast<int>(colours.size()); ++i) {
    const cv::Vec3i off = cv::Vec3i(pixel) - cv::Vec3i(colours[static_cast<std::size_t>(i)]);
    const int square = off.dot(off);
    if (square < least) best = i;
    least = std::min(least, square);
  }
  return static_cast<std::uint8_t>(best);
}

// The number of each pixel's colour.
cv::Mat numbered(const cv::Mat& picture, const std::vector<cv::Vec3b>& colours) {
  constexpr int kDrop = 8 - kBits;
  std::vector<int> known(1U << (3 * kBits), -1);
  cv::Mat numbers(picture.size(), CV_8UC1);
  for (int y = 0; y < picture.rows; ++y)
    for (int x = 0; x < picture.cols; ++x) {
      const cv::Vec3b& pixel = picture.at<cv::Vec3b>(y, x);
      const int key = ((pixel[0] >> kDrop) << (2 * kBits)) | ((pixel[1] >> kDrop) << kBits) |
                      (pixel[2] >> kDrop);
      int& number = known[static_cast<std::size_t>(key)];
      if (number < 0) number = nearest(pixel, colours);
      numbers.at<std::uint8_t>(y, x) = static_cast<std::uint8_t>(number);
    }
  return numbers;
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

Status writeSmallPng(const std::string& path, const cv::Mat& picture) {
  const std::vector<cv::Vec3b> colours = coloursOf(picture);
  return writeIndexedPng(path, numbered(picture, colours), colours);
}

Status writeIndexedPng(const std::string& path, const cv::Mat& numbers,
                       const std::vector<cv::Vec3b>& palette) {
  const cv::Mat rows = numbers.isContinuous() ? numbers : numbers.clone();
  png_image png = header(rows.size());
  png.format = PNG_FORMAT_BGR_COLORMAP;
  png.colormap_entries = static_cast<png_uint_32>(palette.size());
  const std::string part = path + ".part";
  if (rows.type() == CV_8UC1 &&
      png_image_write_to_file(&png, part.c_str(), 0, rows.data, 0, palette.data()) != 0 &&
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
