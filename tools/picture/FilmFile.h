// SPDX-License-Identifier: Apache-2.0
// An H.264 film in an MP4 file, by libav and x264. Frames go in one by one; x264 encodes on as many
// cores as there are.
#pragma once

#include <memory>
#include <opencv2/core.hpp>
#include <string>

#include "robot/core/Expected.h"

namespace kelpie::picture {

class FilmFile {
 public:
  // Both sides even, as H.264 wants them. Errors say what failed, not in which file.
  static Expected<FilmFile> create(const std::string& path, cv::Size size, int framesPerSecond);
  FilmFile(FilmFile&&) noexcept;
  FilmFile& operator=(FilmFile&&) noexcept;
  ~FilmFile();

  // 8 bits a channel, blue green red, of the film's size.
  Status add(const cv::Mat& frame);
  // Writes what is still being encoded and the index, without which no player opens the file.
  Status close();

 private:
  struct Encoder;
  explicit FilmFile(std::unique_ptr<Encoder> encoder);
  std::unique_ptr<Encoder> encoder_;
};

}  // namespace kelpie::picture
