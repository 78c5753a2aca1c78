// SPDX-License-Identifier: Apache-2.0
#include "tools/cli/WholeFile.h"

#include <sys/stat.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
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

bool writeInto(const std::string& path, const std::string& text) {
  std::FILE* file = std::fopen(path.c_str(), "wb");
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
  if (isDevice(path)) return writeInto(path, text);
  std::string part = path + ".XXXXXX";
  const int descriptor = mkstemp(part.data());
  if (descriptor < 0) return false;
  (void)fchmod(descriptor, 0644);  // mkstemp lets nobody else read it
  std::FILE* file = fdopen(descriptor, "wb");
  if (file == nullptr) return false;
  const bool written = std::fwrite(text.data(), 1, text.size(), file) == text.size();
  const bool closed = std::fclose(file) == 0;
  const Status whole = written && closed ? Status(Done{}) : Error{path};
  return putInPlace(whole, part, path).ok();
}

}  // namespace kelpie::cli
