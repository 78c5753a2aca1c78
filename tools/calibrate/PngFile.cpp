// SPDX-License-Identifier: Apache-2.0
#include "tools/calibrate/PngFile.h"

#include <cstdio>
#include <opencv2/imgcodecs.hpp>

namespace kelpie::calibrate {
namespace {

bool writeBytes(const std::string& path, const std::vector<uchar>& bytes) {
  std::FILE* file = std::fopen(path.c_str(), "wb");
  if (file == nullptr) return false;
  const bool written = std::fwrite(bytes.data(), 1, bytes.size(), file) == bytes.size();
  return std::fclose(file) == 0 && written;
}

}  // namespace

Status writePng(const std::string& path, const cv::Mat& picture) {
  std::vector<uchar> bytes;
  const std::string part = path + ".part";
  if (cv::imencode(".png", picture, bytes) && writeBytes(part, bytes) &&
      std::rename(part.c_str(), path.c_str()) == 0)
    return Done{};
  std::remove(part.c_str());
  return Error{path + ": cannot be written"};
}

}  // namespace kelpie::calibrate
