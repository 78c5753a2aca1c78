// SPDX-License-Identifier: Apache-2.0
#include "tools/calibrate/ResidualPicture.h"

#include <filesystem>
#include <opencv2/imgproc.hpp>

#include "tools/picture/PngFile.h"

namespace kelpie::calibrate {
namespace {

constexpr int kScale = 3;  // of the image
constexpr double kLonger = 10.0;
constexpr int kGap = 6;
constexpr int kTitle = 22;
constexpr int kLegend = 20;  // rows of text, one a kind
constexpr int kWide = kScale * kImageWidth;
constexpr int kHigh = kScale * kImageHeight;

const cv::Scalar kInk(30, 30, 30);

cv::Scalar inkOf(SightKind kind) {
  const std::array<cv::Scalar, kSightKindCount> inks = {
      cv::Scalar(190, 60, 220), cv::Scalar(255, 96, 32), cv::Scalar(0, 140, 230),
      cv::Scalar(60, 60, 200), cv::Scalar(40, 140, 40)};
  return inks[static_cast<std::size_t>(kind)];
}

void write(cv::Mat& picture, const std::string& text, cv::Point at, const cv::Scalar& ink) {
  cv::putText(picture, text, at, cv::FONT_HERSHEY_SIMPLEX, 0.45, ink, 1, cv::LINE_AA);
}

std::string pixels(double value) {
  std::array<char, 16> text{};
  std::snprintf(text.data(), text.size(), "%.2f px", value);
  return text.data();
}

void drawPanel(cv::Mat& picture, const char* title, const Residuals& residuals, int left) {
  write(picture, title, {left, kTitle - 6}, kInk);
  const cv::Rect frame(left, kTitle, kWide, kHigh);
  cv::rectangle(picture, frame, cv::Scalar(255, 255, 255), cv::FILLED);
  cv::Mat inside = picture(frame);
  for (const Residual& r : residuals) {
    const auto at = [](double x, double y) {
      return cv::Point(cv::saturate_cast<int>(kScale * x), cv::saturate_cast<int>(kScale * y));
    };
    const cv::Point from = at(r.pixel.x, r.pixel.y);
    cv::line(inside, from, at(r.pixel.x + kLonger * r.miss.x, r.pixel.y + kLonger * r.miss.y),
             inkOf(r.kind), 1, cv::LINE_AA);
  }
  for (std::size_t i = 0; i < kSightKindCount; ++i) {
    const auto kind = static_cast<SightKind>(i);
    const int row = kTitle + kHigh + kLegend * (static_cast<int>(i) + 1);
    write(picture, std::string(nameOf(kind)) + ": median " + pixels(medianMiss(residuals, kind)),
          {left, row - 5}, inkOf(kind));
  }
}

}  // namespace

Status writeResidualPicture(const BodyEstimate& estimate, const std::string& path) {
  if (std::filesystem::path(path).extension() != ".png")
    return Error{path + ": cannot be written as a picture"};
  const int high = kTitle + kHigh + kLegend * static_cast<int>(kSightKindCount) + kGap;
  cv::Mat picture(high, 2 * kWide + 3 * kGap, CV_8UC3, cv::Scalar(235, 235, 235));
  drawPanel(picture, "before, ten times as long", estimate.before, kGap);
  drawPanel(picture, "after", estimate.after, 2 * kGap + kWide);
  return picture::writePng(path, picture);
}

}  // namespace kelpie::calibrate
