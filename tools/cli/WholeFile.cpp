// SPDX-License-Identifier: Apache-2.0
#include "tools/cli/WholeFile.h"

#include <cstdio>
#include <filesystem>

namespace kelpie::cli {

bool isDevice(const std::string& path) {
  std::error_code error;
  return std::filesystem::exists(path, error) && !std::filesystem::is_regular_file(path, error);
}

bool sameFile(const std::string& a, const std::string& b) {
  std::error_code error;
  return std::filesystem::equivalent(a, b, error) && !error;
}

Status putInPlace(const Status& written, const std::string& part, const std::string& out) {
  if (written && std::rename(part.c_str(), out.c_str()) == 0) return Done{};
  std::remove(part.c_str());
  return written ? Status(Error{out + ": cannot be written"}) : written;
}

}  // namespace kelpie::cli
