// SPDX-License-Identifier: Apache-2.0
// A stick's files by the C library's fopen and fread, which the PC and the robot's newlib have. The
// root is a folder of a PC, or "/MS" on the robot (spec openr.md section 6). The C library
// allocates a FILE and a buffer of one block while a file is open, and frees both when it is
// closed. Its own buffer would be of 1 KB or so, and the system asked for so little each time.
#pragma once

#include <array>
#include <cstdio>

#include "robot/stick/StickFiles.h"

namespace kelpie::stick {

class StdioFiles : public StickFiles {
 public:
  // A root that is too long opens nothing.
  explicit StdioFiles(const char* root);
  ~StdioFiles() override;

  bool open(const char* path) override;
  std::int32_t read(std::uint8_t* to, std::size_t count) override;
  void close() override;

 private:
  static constexpr std::size_t kLongestPath = 1024;

  bool append(std::size_t at, const char* words);

  std::array<char, kLongestPath> path_{};
  std::size_t rootLength_ = 0;
  bool rootFits_ = false;
  std::FILE* file_ = nullptr;
};

}  // namespace kelpie::stick
