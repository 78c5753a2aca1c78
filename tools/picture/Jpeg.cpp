// SPDX-License-Identifier: Apache-2.0
#include "tools/picture/Jpeg.h"

#include <turbojpeg.h>

#include <memory>

#include "tools/picture/CameraPicture.h"

namespace kelpie::picture {
namespace {

struct Destroy {
  void operator()(void* handle) const { tjDestroy(handle); }
};
using Handle = std::unique_ptr<void, Destroy>;

}  // namespace

std::vector<std::uint8_t> jpegOf(const Image& image, int quality) {
  const Handle compressor(tjInitCompress());
  const cv::Mat picture = pictureOf(image);
  std::vector<std::uint8_t> bytes(tjBufSize(kImageWidth, kImageHeight, TJSAMP_420));
  unsigned char* to = bytes.data();
  unsigned long size = bytes.size();
  if (!compressor || tjCompress2(compressor.get(), picture.data, kImageWidth, 0, kImageHeight,
                                 TJPF_BGR, &to, &size, TJSAMP_420, quality, TJFLAG_NOREALLOC) != 0)
    return {};
  bytes.resize(size);
  return bytes;
}

bool imageOfJpeg(const std::uint8_t* bytes, std::size_t size, Image& image) {
  const Handle expander(tjInitDecompress());
  int width = 0;
  int height = 0;
  int sampling = -1;
  int colours = -1;
  if (!expander ||
      tjDecompressHeader3(expander.get(), bytes, size, &width, &height, &sampling, &colours) != 0)
    return false;
  if (width != kImageWidth || height != kImageHeight) return false;
  cv::Mat picture(kImageHeight, kImageWidth, CV_8UC3);
  if (tjDecompress2(expander.get(), bytes, size, picture.data, width, 0, height, TJPF_BGR, 0) != 0)
    return false;
  image = imageOf(picture);
  return true;
}

}  // namespace kelpie::picture
