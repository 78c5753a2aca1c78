// SPDX-License-Identifier: Apache-2.0
#include "tools/teleop/Blocks.h"

#include <fmt/core.h>

#include <algorithm>
#include <opencv2/imgproc.hpp>

#include "tools/picture/CameraPicture.h"

namespace kelpie::teleop {
namespace {

constexpr int kFewestColumns = 26;  // below, a ball at 1 m is less than one block wide
constexpr const char* kUpperHalf = "\u2580";
constexpr const char* kPlain = "\033[0m";

// A colour that the terminal has already is not sent again: half of the bytes.
void setColour(const char* what, const cv::Vec3b& colour, cv::Vec3b& now, bool first,
               std::string& text) {
  if (!first && colour == now) return;
  now = colour;
  text += fmt::format("\033[{};2;{};{};{}m", what, colour[2], colour[1], colour[0]);
}

}  // namespace

TextSize pictureSize(TextSize room) {
  const int wide = std::min(room.columns, 2 * room.rows * kImageWidth / kImageHeight);
  const int columns = std::min(wide, static_cast<int>(kImageWidth));
  const int rows = columns * kImageHeight / kImageWidth / 2;
  return columns < kFewestColumns ? TextSize{} : TextSize{columns, rows};
}

std::vector<std::string> blocksOf(const Image& image, TextSize size) {
  cv::Mat pixels;
  cv::resize(picture::pictureOf(image), pixels, cv::Size(size.columns, 2 * size.rows), 0, 0,
             cv::INTER_AREA);
  std::vector<std::string> lines;
  for (int row = 0; row < size.rows; ++row) {
    std::string text;
    cv::Vec3b upper, lower;
    for (int column = 0; column < size.columns; ++column) {
      setColour("38", pixels.at<cv::Vec3b>(2 * row, column), upper, column == 0, text);
      setColour("48", pixels.at<cv::Vec3b>(2 * row + 1, column), lower, column == 0, text);
      text += kUpperHalf;
    }
    lines.push_back(text + kPlain);
  }
  return lines;
}

}  // namespace kelpie::teleop
