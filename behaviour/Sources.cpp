// SPDX-License-Identifier: Apache-2.0
#include "behaviour/Sources.h"

#include <filesystem>
#include <string_view>
#include <system_error>

namespace kelpie::behaviour {
namespace {

namespace fs = std::filesystem;

std::uint64_t mixed(std::uint64_t hash, std::string_view bytes) {
  for (const char c : bytes) {
    hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3ULL;  // FNV-1a
  }
  return hash;
}

std::uint64_t fileStamp(const fs::path& path) {
  std::error_code error;
  const auto time = fs::last_write_time(path, error).time_since_epoch().count();
  const auto size = fs::file_size(path, error);
  return mixed(0xcbf29ce484222325ULL,
               path.string() + ' ' + std::to_string(time) + ' ' + std::to_string(size));
}

}  // namespace

std::uint64_t sourceStamp(const std::string& scripts) {
  std::error_code error;
  if (!fs::exists(scripts, error)) return 0;
  if (!fs::is_directory(scripts, error)) return fileStamp(scripts);
  std::uint64_t sum = 1;  // a sum: the order in which a folder is listed does not matter
  const auto options = fs::directory_options::skip_permission_denied;
  for (fs::recursive_directory_iterator it(scripts, options, error), end; it != end && !error;
       it.increment(error)) {
    if (it->path().extension() == ".py") sum += fileStamp(it->path());
  }
  return sum;
}

bool isZip(const std::string& scripts) {
  std::error_code error;
  return fs::is_regular_file(scripts, error);
}

}  // namespace kelpie::behaviour
