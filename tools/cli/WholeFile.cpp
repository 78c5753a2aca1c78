// SPDX-License-Identifier: Apache-2.0
#include "tools/cli/WholeFile.h"

#include <unistd.h>

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

namespace {

// Closes it, too.
bool writeAll(std::FILE* file, const std::string& text) {
  if (file == nullptr) return false;
  const bool written = std::fwrite(text.data(), 1, text.size(), file) == text.size();
  return std::fclose(file) == 0 && written;
}

}  // namespace

bool canWrite(const std::string& path) {
  if (path == "-") return true;
  std::error_code error;
  if (std::filesystem::is_directory(path, error)) return false;
  if (isDevice(path)) return access(path.c_str(), W_OK) == 0;
  const auto cut = path.rfind('/');
  const std::string folder = cut == std::string::npos ? "." : path.substr(0, cut + 1);
  return !path.empty() && access(folder.c_str(), W_OK | X_OK) == 0;
}

bool writeWhole(const std::string& path, const std::string& text) {
  if (path == "-") return std::fwrite(text.data(), 1, text.size(), stdout) == text.size();
  if (isDevice(path)) return writeAll(std::fopen(path.c_str(), "wb"), text);
  // A name of our own, and none that is there already: it may be the user's.
  const std::string part = path + "." + std::to_string(getpid()) + ".part";
  std::FILE* file = std::fopen(part.c_str(), "wbx");
  if (file == nullptr) return false;
  const Status whole = writeAll(file, text) ? Status(Done{}) : Error{path};
  return putInPlace(whole, part, path).ok();
}

}  // namespace kelpie::cli
