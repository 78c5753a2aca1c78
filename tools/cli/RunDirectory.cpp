// SPDX-License-Identifier: Apache-2.0
#include "tools/cli/RunDirectory.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <fstream>

namespace kelpie::cli {
namespace {

namespace fs = std::filesystem;

constexpr const char* kPrefix = "kelpie-play-";
// In each folder of ours: one of a user's may have such a name, and is not to be removed.
constexpr const char* kMark = ".running-match";
// Between the making of a folder and its lock; a younger one may still be without.
constexpr std::time_t kYoung = 10;  // s

// The locked folder, or -1 when it is somebody else's, in use, or no folder.
int lockFolder(const std::string& path) {
  const int folder = open(path.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
  struct stat is {};
  const bool ours = folder >= 0 && fstat(folder, &is) == 0 && is.st_uid == geteuid() &&
                    flock(folder, LOCK_EX | LOCK_NB) == 0;
  if (ours) return folder;
  if (folder >= 0) close(folder);
  return -1;
}

bool isYoung(int folder) {
  struct stat is {};
  return fstat(folder, &is) != 0 || std::time(nullptr) - is.st_mtime < kYoung;
}

void removeLeftBehind(const fs::path& where) {
  std::error_code error;
  for (fs::directory_iterator entry(where, error), end; !error && entry != end;
       entry.increment(error)) {
    const std::string path = entry->path().string();
    if (entry->path().filename().string().rfind(kPrefix, 0) != 0) continue;
    std::error_code unmarked;
    if (!fs::is_regular_file(entry->path() / kMark, unmarked)) continue;
    const int folder = lockFolder(path);
    if (folder < 0) continue;
    std::error_code ignored;
    if (!isYoung(folder)) fs::remove_all(path, ignored);
    close(folder);
  }
}

}  // namespace

RunDirectory::RunDirectory() {
  std::error_code error;
  const fs::path where = fs::temp_directory_path(error);
  if (error) return;
  removeLeftBehind(where);
  std::string pattern = (where / (std::string(kPrefix) + "XXXXXX")).string();
  if (mkdtemp(pattern.data()) == nullptr) return;
  folder_ = pattern;
  lock_ = lockFolder(folder_);
  std::ofstream mark(path(kMark));
}

RunDirectory::~RunDirectory() {
  std::error_code ignored;
  if (!folder_.empty()) fs::remove_all(folder_, ignored);
  if (lock_ >= 0) close(lock_);
}

}  // namespace kelpie::cli
