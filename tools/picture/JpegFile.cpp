// SPDX-License-Identifier: Apache-2.0
#include "tools/picture/JpegFile.h"

#include <turbojpeg.h>

#include <cstdio>
#include <fstream>
#include <vector>

namespace kelpie::picture {
namespace {

constexpr int kQuality = 92;  // thin lines and small text stay sharp

// Empty when the library fails.
std::vector<unsigned char> bytesOf(const cv::Mat& rows) {
  const tjhandle compressor = tjInitCompress();
  if (compressor == nullptr || rows.type() != CV_8UC3) return {};
  std::vector<unsigned char> bytes(tjBufSize(rows.cols, rows.rows, TJSAMP_444));
  unsigned char* to = bytes.data();
  unsigned long size = bytes.size();
  const int failed = tjCompress2(compressor, rows.data, rows.cols, 0, rows.rows, TJPF_BGR, &to,
                                 &size, TJSAMP_444, kQuality, TJFLAG_NOREALLOC);
  tjDestroy(compressor);
  bytes.resize(failed != 0 ? 0 : size);
  return bytes;
}

}  // namespace

Status writeJpeg(const std::string& path, const cv::Mat& picture) {
  const auto bytes = bytesOf(picture.isContinuous() ? picture : picture.clone());
  const std::string part = path + ".part";
  std::ofstream file(part, std::ios::binary);
  file.write(reinterpret_cast<const char*>(bytes.data()),
             static_cast<std::streamsize>(bytes.size()));
  file.close();
  if (!bytes.empty() && file && std::rename(part.c_str(), path.c_str()) == 0) return Done{};
  std::remove(part.c_str());
  return Error{path + ": cannot be written"};
}

}  // namespace kelpie::picture
