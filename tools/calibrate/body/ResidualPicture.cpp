// SPDX-License-Identifier: Apache-2.0
#include "tools/calibrate/body/ResidualPicture.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <opencv2/imgproc.hpp>

#include "tools/calibrate/Quantile.h"
#include "tools/picture/FileNames.h"
#include "tools/picture/PngFile.h"

namespace kelpie::calibrate {
namespace {

constexpr int kScale = 2;  // of the image
constexpr double kLongest = 10.0;
constexpr double kReadable = 16.0;  // px of the image, strokes of most misses at most
constexpr int kGap = 8;
constexpr int kTitle = 22;
constexpr int kLegend = 20;  // rows of text, one a kind
constexpr int kWide = kScale * kImageWidth;
constexpr int kHigh = kScale * kImageHeight;

struct Panel {
  const char* title;
  const Residuals& residuals;
  double longer;  // strokes than misses
};

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

void drawStrokes(cv::Mat& inside, const Panel& panel) {
  const auto at = [](double x, double y) {
    return cv::Point(cv::saturate_cast<int>(kScale * x), cv::saturate_cast<int>(kScale * y));
  };
  for (const Residual& r : panel.residuals) {
    const cv::Point seen = at(r.pixel.x, r.pixel.y);
    const cv::Point should =
        at(r.pixel.x - panel.longer * r.miss.x, r.pixel.y - panel.longer * r.miss.y);
    cv::line(inside, seen, should, inkOf(r.kind), 1, cv::LINE_AA);
    cv::circle(inside, seen, 1, inkOf(r.kind), cv::FILLED, cv::LINE_AA);
  }
}

void drawPanel(cv::Mat& picture, const Panel& panel, int left) {
  const std::string title =
      std::string(panel.title) + ", strokes " + std::to_string(std::lround(panel.longer));
  write(picture, title + " times the miss", {left, kTitle - 6}, kInk);
  const cv::Rect frame(left, kTitle, kWide, kHigh);
  cv::rectangle(picture, frame, cv::Scalar(255, 255, 255), cv::FILLED);
  cv::Mat inside = picture(frame);
  drawStrokes(inside, panel);
  for (std::size_t i = 0; i < kSightKindCount; ++i) {
    const auto kind = static_cast<SightKind>(i);
    const int row = kTitle + kHigh + kLegend * (static_cast<int>(i) + 1);
    write(picture,
          std::string(nameOf(kind)) + ": median " + pixels(medianMiss(panel.residuals, kind)),
          {left, row - 5}, inkOf(kind));
  }
}

// So many times longer that the strokes of nine in ten are readable.
double lengthFor(const Residuals& residuals) {
  std::vector<double> sizes;
  for (const Residual& r : residuals) sizes.push_back(std::hypot(r.miss.x, r.miss.y));
  if (sizes.empty()) return kLongest;
  return maths::clamp(std::floor(kReadable / std::max(quantile(sizes, 0.9), 0.1)), 1.0, kLongest);
}

}  // namespace

Status writeResidualPicture(const BodyEstimate& estimate, const std::string& path) {
  if (picture::endingOf(path) != ".png") return Error{path + ": cannot be written as a picture"};
  const int high = kTitle + kHigh + kLegend * static_cast<int>(kSightKindCount) + kGap;
  const double longer = lengthFor(estimate.before);
  const std::array<Panel, 3> panels = {{{"before", estimate.before, longer},
                                        {"after", estimate.after, longer},
                                        {"after", estimate.after, kLongest}}};
  cv::Mat picture(high, 3 * kWide + 4 * kGap, CV_8UC3, cv::Scalar(235, 235, 235));
  for (int i = 0; i < 3; ++i)
    drawPanel(picture, panels[static_cast<std::size_t>(i)], kGap + i * (kWide + kGap));
  return picture::writePng(path, picture);
}

}  // namespace kelpie::calibrate
