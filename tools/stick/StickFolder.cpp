// SPDX-License-Identifier: Apache-2.0
#include "tools/stick/StickFolder.h"

#include <fcntl.h>
#include <fmt/core.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>

#include "robot/stick/StickFormat.h"
#include "tools/cli/Process.h"
#include "tools/stick/Programs.h"

namespace kelpie::stick {
namespace {

namespace fs = std::filesystem;

constexpr const char* kSystemFiles[] = {"OPEN-R/APERIOS.GZ", "OPEN-R/APERINIT.GZ",
                                        "OPEN-R/BOOTPARA"};
constexpr const char* kSystemFolders[] = {"OPEN-R/SYSTEM/OBJS", "OPEN-R/SYSTEM/CONF"};
constexpr const char* kRadioDrivers = "OPEN-R/SYSTEM/CONF/CARDDRV.CFG";

Error systemError(const std::string& path) { return Error{path + ": " + std::strerror(errno)}; }

// OBJECT.CFG -> OBJECT.NEW: 8.3 names have no room for more.
std::string stagedName(const std::string& path) {
  return fs::path(path).replace_extension("NEW").string();
}

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

// Written, on the medium, and read back from there.
Status stage(const std::string& path, const std::string& bytes) {
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

// Some file systems cannot sync a folder; there the file's own sync must do.
void syncFolder(const fs::path& folder) {
  const Descriptor file(folder.string(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (file.number() >= 0) fsync(file.number());
}

StickTree differing(const StickTree& tree, const fs::path& root) {
  StickTree changed;
  for (const auto& file : tree) {
    const auto old = readWhole((root / file.path).string());
    if (!old || *old != file.bytes) changed.push_back(file);
  }
  return changed;
}

Status stageAll(const StickTree& files, const fs::path& root, const StepObserver& step) {
  for (const auto& file : files) {
    const fs::path path = root / file.path;
    step("write " + file.path);
    if (cli::interrupted()) return Error{"stopped; " + root.string() + " is as it was"};
    std::error_code error;
    if (fs::is_directory(path, error)) return Error{path.string() + ": is a folder, not a file"};
    Status staged = makeFolder(path.parent_path());
    if (staged) staged = stage(stagedName(path.string()), file.bytes);
    if (!staged) return staged;
  }
  return Done{};
}

Status renameAll(const StickTree& files, const fs::path& root, const StepObserver& step) {
  for (const auto& file : files) {
    const fs::path path = root / file.path;
    step("rename " + file.path);
    if (std::rename(stagedName(path.string()).c_str(), path.c_str()) != 0)
      return Error{systemError(path.string()).message +
                   "; the files now are a mixture that no robot plays, until " +
                   "the same command goes to its end"};
    syncFolder(path.parent_path());
  }
  return Done{};
}

Error lacks(const std::string& root, const char* what) {
  return Error{
      fmt::format("{}: lacks {}; a programming stick with Sony's system on it is needed "
                  "(docs/flash.md)",
                  root, what)};
}

void removeStaged(const StickTree& files, const fs::path& root) {
  std::error_code ignored;
  for (const auto& file : files) fs::remove(stagedName((root / file.path).string()), ignored);
}

}  // namespace

Status checkMount(const StickTree& tree, const std::string& root) {
  std::error_code error;
  if (!fs::is_directory(root, error)) return Error{root + ": is not a folder"};
  for (const auto* file : kSystemFiles)
    if (!fs::is_regular_file(fs::path(root) / file, error)) return lacks(root, file);
  for (const auto* folder : kSystemFolders)
    if (!fs::is_directory(fs::path(root) / folder, error)) return lacks(root, folder);
  if (findFile(tree, kWlanPath) != nullptr && !fs::exists(fs::path(root) / kRadioDrivers, error))
    return Error{root + ": its system is one without a radio (no " + kRadioDrivers + ")"};
  return Done{};
}

Status checkFolder(const StickTree& tree, const std::string& root) {
  std::error_code error;
  if (fs::exists(root, error) && !fs::is_directory(root, error))
    return Error{root + ": is not a folder"};
  for (const auto* file : kSystemFiles)
    if (fs::exists(fs::path(root) / file, error))
      return Error{root + ": looks like a programming stick; --install writes to one"};
  for (const auto* path : {kObjectPath, kWlanPath, kJamPath})
    if (findFile(tree, path) == nullptr && fs::exists(fs::path(root) / path, error))
      return Error{root + ": holds " + path + ", which this stick would lack; remove it first"};
  return Done{};
}

Status writeFiles(const StickTree& tree, const std::string& root, const StepObserver& step) {
  removeStaged(tree, root);  // what a stop in the middle left
  const StickTree changed = differing(tree, root);
  const Status staged = stageAll(changed, root, step);
  if (!staged) {
    removeStaged(changed, root);
    return staged;
  }
  return renameAll(changed, root, step);
}

}  // namespace kelpie::stick
