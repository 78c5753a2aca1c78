// SPDX-License-Identifier: Apache-2.0
#include "tools/calibrate/colour/TablePicture.h"

#include <filesystem>
#include <opencv2/imgproc.hpp>

#include "tools/picture/FileNames.h"
#include "tools/picture/PngFile.h"

namespace kelpie::calibrate {
namespace {

constexpr int kAcross = 4;  // slices side by side
constexpr int kSlices = 8;
constexpr int kSize = 256;  // pixels a slice
constexpr int kGap = 4;
constexpr int kTitle = 18;

void drawSlice(cv::Mat& picture, const vision::ColourTable& table, int slice) {
  const int left = kGap + slice % kAcross * (kSize + kGap);
  const int top = kTitle + slice / kAcross * (kSize + kTitle);
  const int y = (2 * slice + 1) * 256 / (2 * kSlices);
  for (int cr = 0; cr < 256; ++cr)
    for (int cb = 0; cb < 256; ++cb) {
      const auto byte = [](int v) { return static_cast<std::uint8_t>(v); };
      const auto colour =
          vision::kColourPalette[vision::index(table({byte(y), byte(cr), byte(cb)}))];
      picture.at<cv::Vec3b>(top + 255 - cb, left + cr) = {colour.b, colour.g, colour.r};
    }
  cv::putText(picture, "Y " + std::to_string(y), {left, top - 5}, cv::FONT_HERSHEY_SIMPLEX, 0.45,
              {0, 0, 0}, 1, cv::LINE_AA);
}

}  // namespace

Status writeTablePicture(const vision::ColourTable& table, const std::string& path) {
  if (picture::endingOf(path) != ".png") return Error{path + ": cannot be written as a picture"};
  cv::Mat picture(kSlices / kAcross * (kSize + kTitle) + kGap, kAcross * (kSize + kGap) + kGap,
                  CV_8UC3, cv::Scalar(235, 235, 235));
  for (int slice = 0; slice < kSlices; ++slice) drawSlice(picture, table, slice);
  return picture::writePng(path, picture);
}

}  // namespace kelpie::calibrate
