// SPDX-License-Identifier: Apache-2.0
#include "tools/picture/Jpeg.h"

#include <turbojpeg.h>

#include <array>
#include <memory>

namespace kelpie::picture {
namespace {

struct Destroy {
  void operator()(void* handle) const { tjDestroy(handle); }
};
using Handle = std::unique_ptr<void, Destroy>;

}  // namespace

std::vector<std::uint8_t> jpegOf(const Image& image, int quality) {
  const Handle compressor(tjInitCompress());
  std::array<const unsigned char*, 3> planes = {image.y.data(), image.cb.data(), image.cr.data()};
  std::vector<std::uint8_t> bytes(tjBufSize(kImageWidth, kImageHeight, TJSAMP_444));
  unsigned char* to = bytes.data();
  unsigned long size = bytes.size();
  if (!compressor ||
      tjCompressFromYUVPlanes(compressor.get(), planes.data(), kImageWidth, nullptr, kImageHeight,
                              TJSAMP_444, &to, &size, quality, TJFLAG_NOREALLOC) != 0)
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
  if (width != kImageWidth || height != kImageHeight || sampling != TJSAMP_444) return false;
  std::array<unsigned char*, 3> planes = {image.y.data(), image.cb.data(), image.cr.data()};
  return tjDecompressToYUVPlanes(expander.get(), bytes, size, planes.data(), width, nullptr, height,
                                 0) == 0;
}

}  // namespace kelpie::picture
