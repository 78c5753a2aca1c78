// SPDX-License-Identifier: Apache-2.0
// Whole files, folders that go with their object, and other programs run to their end.
#pragma once

#include <string>
#include <vector>

#include "robot/core/Expected.h"

namespace kelpie::stick {

// "FILE: does not exist", "is a folder", "cannot be read".
Expected<std::string> readWhole(const std::string& file);

// A folder of our own, removed with all that is in it.
class ScratchFolder {
 public:
  static Expected<ScratchFolder> make();
  ScratchFolder(ScratchFolder&& other) noexcept;
  ScratchFolder& operator=(ScratchFolder&&) = delete;
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  ~ScratchFolder();
  const std::string& path() const { return path_; }

 private:
  explicit ScratchFolder(std::string path) : path_(std::move(path)) {}
  std::string path_;
};

// The first of these that is in $PATH or is a path of a program; empty when there is none.
std::string findProgram(const std::vector<std::string>& names);

// Its output; the error is its last line when it fails. argv[0] is a path.
Expected<std::string> runProgram(const std::vector<std::string>& argv);

}  // namespace kelpie::stick
