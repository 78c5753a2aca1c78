// SPDX-License-Identifier: Apache-2.0
#include "robot/stick/StdioFiles.h"

#include <cstring>

namespace kelpie::stick {

StdioFiles::StdioFiles(const char* root) : rootLength_(std::strlen(root)) {
  rootFits_ = append(0, root) && append(rootLength_, "/");
}

StdioFiles::~StdioFiles() { StdioFiles::close(); }

bool StdioFiles::append(std::size_t at, const char* words) {
  const std::size_t length = std::strlen(words);
  if (at + length >= path_.size()) return false;
  std::memcpy(path_.data() + at, words, length + 1);
  return true;
}

bool StdioFiles::open(const char* path) {
  close();
  if (!rootFits_ || !append(rootLength_ + 1, path)) return false;
  file_ = std::fopen(path_.data(), "rb");
  if (file_ == nullptr) return false;
  std::setvbuf(file_, nullptr, _IOFBF, kBlockBytes);  // without it all is read the same, but slower
  return true;
}

std::int32_t StdioFiles::read(std::uint8_t* to, std::size_t count) {
  if (file_ == nullptr) return -1;
  const std::size_t got = std::fread(to, 1, count, file_);
  if (got < count && std::ferror(file_) != 0) return -1;
  return static_cast<std::int32_t>(got);
}

void StdioFiles::close() {
  if (file_ != nullptr) std::fclose(file_);
  file_ = nullptr;
}

}  // namespace kelpie::stick
