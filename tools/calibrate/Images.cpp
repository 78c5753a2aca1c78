// SPDX-License-Identifier: Apache-2.0
#include "tools/calibrate/Images.h"

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "robot/core/log/LogReader.h"
#include "robot/core/log/LogTopics.h"
#include "robot/core/types/FrameInput.h"
#include "tools/picture/CameraPicture.h"
#include "tools/picture/FileNames.h"
#include "tools/picture/PngFile.h"

namespace kelpie::calibrate {
namespace {

namespace fs = std::filesystem;

std::string sized(const std::string& path, const std::string& found, const char* wanted) {
  return path + ": " + found + ", expected " + wanted;
}

Expected<std::vector<std::uint8_t>> readRaw(const std::string& path) {
  std::error_code error;
  const auto size = fs::file_size(path, error);
  if (error) return Error{path + ": " + error.message()};
  if (size != 3 * kImagePixels)
    return Error{
        sized(path, std::to_string(size) + " bytes", "99840 (planes Y, Cr, Cb of 208 x 160)")};
  std::vector<std::uint8_t> bytes(3 * kImagePixels);
  std::ifstream file(path, std::ios::binary);
  file.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  if (!file) return Error{path + ": cannot be read"};
  return bytes;
}

Image fromPlanes(const std::vector<std::uint8_t>& bytes) {
  Image image;
  const std::uint8_t* next = bytes.data();
  for (auto* plane : {&image.y, &image.cr, &image.cb}) {
    std::copy_n(next, kImagePixels, plane->data());
    next += kImagePixels;
  }
  return image;
}

// 160 rows, each of 208 Y, 208 Cr, 208 Cb (data/README.md).
Image fromRows(const std::vector<std::uint8_t>& bytes) {
  Image image;
  const std::uint8_t* next = bytes.data();
  for (int row = 0; row < kImageHeight; ++row) {
    for (auto* plane : {&image.y, &image.cr, &image.cb}) {
      std::copy_n(next, kImageWidth, plane->data() + Image::at(0, row));
      next += kImageWidth;
    }
  }
  return image;
}

Expected<Image> fromPicture(const std::string& path) {
  const auto picture = picture::readPng(path);
  if (!picture) return Error{picture.error()};
  if (picture->cols != kImageWidth || picture->rows != kImageHeight)
    return Error{sized(
        path, std::to_string(picture->cols) + " x " + std::to_string(picture->rows) + " pixels",
        "208 x 160")};
  return picture::imageOf(*picture);
}

bool isImage(const fs::path& path) {
  const auto extension = picture::endingOf(path);
  return extension == ".png" || extension == ".yuv" || extension == ".bin";
}

Expected<std::vector<NamedImage>> fromFolder(const std::string& folder) {
  std::error_code error;
  std::vector<std::string> files;
  for (const auto& entry : fs::directory_iterator(folder, error)) {
    if (isImage(entry.path())) files.push_back(entry.path().string());
  }
  if (error) return Error{folder + ": " + error.message()};
  if (files.empty()) return Error{folder + ": no .png, .yuv or .bin images"};
  std::sort(files.begin(), files.end());
  std::vector<NamedImage> images;
  for (const auto& file : files) {
    const auto image = readImage(file);
    if (!image) return Error{image.error()};
    images.push_back({file, *image});
  }
  return images;
}

// Calls take(input) for every frame of the log.
template <class Take>
Status forEachFrame(const std::string& path, Take&& take) {
  auto reader = LogReader::open(path);
  if (!reader) return Error{reader.error()};
  LogMessage message;
  FrameInput input;
  while (reader->next(message)) {
    if (message.topic() != kFrameInputTopic) continue;
    const Status decoded = decodeAs(message, input);
    if (!decoded) return Error{path + ": " + decoded.error()};
    take(input);
  }
  return reader->status();
}

Expected<std::vector<NamedImage>> fromLog(const std::string& path, std::size_t max) {
  std::size_t count = 0;
  const Status counted = forEachFrame(path, [&](const FrameInput&) { ++count; });
  if (!counted) return Error{counted.error()};
  if (count == 0) return Error{path + ": no frames"};
  const std::size_t every = (count + max - 1) / max;
  std::vector<NamedImage> images;
  std::size_t at = 0;
  const Status taken = forEachFrame(path, [&](const FrameInput& input) {
    if (at++ % every == 0)
      images.push_back({path + " frame " + std::to_string(input.frame), input.image});
  });
  if (!taken) return Error{taken.error()};
  return images;
}

}  // namespace

Expected<Image> readImage(const std::string& path) {
  const auto extension = picture::endingOf(path);
  if (extension == ".png") return fromPicture(path);
  const auto bytes = readRaw(path);
  if (!bytes) return Error{bytes.error()};
  return extension == ".bin" ? fromRows(*bytes) : fromPlanes(*bytes);
}

Expected<std::vector<NamedImage>> readImages(const std::string& path, std::size_t max) {
  std::error_code error;
  if (!fs::exists(path, error)) return Error{path + ": no such folder or log"};
  return fs::is_directory(path, error) ? fromFolder(path) : fromLog(path, max);
}

Status writePicture(const Image& image, const std::string& path) {
  return picture::writePng(path, picture::pictureOf(image));
}

}  // namespace kelpie::calibrate
