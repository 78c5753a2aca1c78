// SPDX-License-Identifier: Apache-2.0
#include "tools/cli/calibrate/GainPicture.h"

#include <fmt/core.h>

#include <algorithm>
#include <opencv2/imgproc.hpp>

#include "tools/picture/PngFile.h"

namespace kelpie::cli {
namespace {

constexpr int kWide = 800;
constexpr int kHigh = 400;
constexpr int kEdge = 50;

void write(cv::Mat& picture, const std::string& text, int x, int y) {
  cv::putText(picture, text, {x, y}, cv::FONT_HERSHEY_SIMPLEX, 0.45, {30, 30, 30}, 1, cv::LINE_AA);
}

}  // namespace

Status drawGain(const std::vector<double>& gains, const std::string& title,
                const std::string& path) {
  if (gains.empty()) return Error{path + ": there is nothing to draw"};
  const double max = gains.back();
  // What the first trials gain says little: the curve begins with the first tenth's best.
  const double min = gains[gains.size() / 10];
  const double range = std::max(max - min, 1e-9);
  cv::Mat picture(kHigh, kWide, CV_8UC3, cv::Scalar(250, 250, 250));
  const auto at = [&](std::size_t i) {
    const double x =
        static_cast<double>(i) / static_cast<double>(std::max<std::size_t>(1, gains.size() - 1));
    const double y = std::clamp((gains[i] - min) / range, 0.0, 1.0);
    return cv::Point(kEdge + static_cast<int>(x * (kWide - 2 * kEdge)),
                     kHigh - kEdge - static_cast<int>(y * (kHigh - 2 * kEdge)));
  };
  cv::rectangle(picture, {kEdge, kEdge}, {kWide - kEdge, kHigh - kEdge}, {200, 200, 200});
  for (std::size_t i = 1; i < gains.size(); ++i)
    cv::line(picture, at(i - 1), at(i), {190, 90, 30}, 2, cv::LINE_AA);
  write(picture, title, kEdge, kEdge - 14);
  write(picture, fmt::format("{:.2f}", max), 6, kEdge + 5);
  write(picture, fmt::format("{:.2f}", min), 6, kHigh - kEdge + 5);
  write(picture, fmt::format("gain after {} trials", gains.size()), kEdge, kHigh - 18);
  return picture::writePng(path, picture);
}

}  // namespace kelpie::cli
