// SPDX-License-Identifier: Apache-2.0
#include "tools/stick/StickTree.h"

#include <algorithm>
#include <cstring>

namespace kelpie::stick {
namespace {

bool isShortPart(const std::string& part, std::size_t longest) {
  constexpr const char* kAllowed = "ABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-";
  return !part.empty() && part.size() <= longest &&
         part.find_first_not_of(kAllowed) == std::string::npos;
}

bool isShortWord(const std::string& word) {
  const std::size_t dot = word.find('.');
  if (dot == std::string::npos) return isShortPart(word, 8);
  return isShortPart(word.substr(0, dot), 8) && isShortPart(word.substr(dot + 1), 3);
}

}  // namespace

bool isShortName(const std::string& path) {
  std::size_t start = 0;
  for (;;) {
    const std::size_t end = path.find('/', start);
    if (!isShortWord(path.substr(start, end - start))) return false;
    if (end == std::string::npos) return true;
    start = end + 1;
  }
}

std::size_t bytesOf(const StickTree& tree) {
  std::size_t bytes = 0;
  for (const auto& file : tree) bytes += file.bytes.size();
  return bytes;
}

const TreeFile* findFile(const StickTree& tree, const std::string& path) {
  const auto found =
      std::find_if(tree.begin(), tree.end(), [&](const auto& file) { return file.path == path; });
  return found == tree.end() ? nullptr : &*found;
}

bool TreeFiles::open(const char* path) {
  file_ = findFile(tree_, path);
  at_ = 0;
  return file_ != nullptr;
}

std::int32_t TreeFiles::read(std::uint8_t* to, std::size_t count) {
  if (file_ == nullptr) return -1;
  const std::size_t got = std::min(count, file_->bytes.size() - at_);
  std::memcpy(to, file_->bytes.data() + at_, got);
  at_ += got;
  return static_cast<std::int32_t>(got);
}

}  // namespace kelpie::stick
