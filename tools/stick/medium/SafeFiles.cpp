// SPDX-License-Identifier: Apache-2.0
#include "tools/stick/medium/SafeFiles.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "tools/stick/Programs.h"

namespace kelpie::stick {
namespace {

namespace fs = std::filesystem;

// A descriptor that is closed; fsync by hand, so that an error is seen.
class Descriptor {
 public:
  Descriptor(const std::string& path, int flags) : number_(::open(path.c_str(), flags, 0644)) {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() {
    if (number_ >= 0) ::close(number_);
  }
  int number() const { return number_; }

 private:
  int number_;
};

bool writeAll(int file, const std::string& bytes) {
  std::size_t at = 0;
  while (at < bytes.size()) {
    const ssize_t wrote = ::write(file, bytes.data() + at, bytes.size() - at);
    if (wrote < 0 && errno == EINTR) continue;
    if (wrote <= 0) return false;
    at += static_cast<std::size_t>(wrote);
  }
  return true;
}

}  // namespace

Error systemError(const std::string& path) { return Error{path + ": " + std::strerror(errno)}; }

Status writeSynced(const std::string& path, const std::string& bytes) {
  {
    const Descriptor file(path, O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC);
    if (file.number() < 0 || !writeAll(file.number(), bytes) || fsync(file.number()) != 0)
      return systemError(path);
    posix_fadvise(file.number(), 0, 0, POSIX_FADV_DONTNEED);
  }
  const auto back = readWhole(path);
  if (!back) return Error{back.error()};
  return *back == bytes ? Status(Done{}) : Error{path + ": reads back otherwise than written"};
}

Status makeFolder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  return error ? Status(Error{folder.string() + ": " + error.message()}) : Done{};
}

void syncFolder(const fs::path& folder) {
  const Descriptor file(folder.string(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (file.number() >= 0) fsync(file.number());
}

Status syncFileSystem(const fs::path& folder) {
  const Descriptor file(folder.string(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  const bool synced = file.number() >= 0 && syncfs(file.number()) == 0;
  return synced ? Status(Done{}) : systemError(folder.string());
}

}  // namespace kelpie::stick
