// SPDX-License-Identifier: Apache-2.0
#include "tools/stick/medium/StickFolder.h"

#include <fmt/core.h>

#include <cstdio>
#include <filesystem>
#include <vector>

#include "robot/stick/StickFormat.h"
#include "tools/cli/Process.h"
#include "tools/stick/Programs.h"
#include "tools/stick/medium/SafeFiles.h"

namespace kelpie::stick {
namespace {

namespace fs = std::filesystem;

constexpr const char* kSystemFiles[] = {"OPEN-R/APERIOS.GZ", "OPEN-R/APERINIT.GZ",
                                        "OPEN-R/BOOTPARA"};
constexpr const char* kSystemFolders[] = {"OPEN-R/SYSTEM/OBJS", "OPEN-R/SYSTEM/CONF"};
constexpr const char* kRadioDrivers = "OPEN-R/SYSTEM/CONF/CARDDRV.CFG";

// The names of a tree's files differ also without their folders.
fs::path stagedPath(const fs::path& root, const TreeFile& file) {
  return root / kUnfinished / fs::path(file.path).filename();
}

void removeStaged(const fs::path& root) {
  std::error_code ignored;
  fs::remove_all(root / kUnfinished, ignored);
}

StickTree differing(const StickTree& tree, const fs::path& root) {
  StickTree changed;
  for (const auto& file : tree) {
    const auto old = readWhole((root / file.path).string());
    if (!old || *old != file.bytes) changed.push_back(file);
  }
  return changed;
}

// In which order files take their places. What is new stands beside the earlier files and changes
// nothing for them. OBJECT.CFG, which says what program runs, is the first of those that replace
// another: until then a former program has all that it had, and from then on our own reader runs,
// which refuses the stick until STICK.BIN, the last, is there.
StickTree inOrder(const StickTree& files, const fs::path& root) {
  const auto rank = [&](const TreeFile& file) {
    if (file.path == kStickPath) return 2;
    std::error_code error;
    return fs::exists(root / file.path, error) ? 1 : 0;
  };
  StickTree ordered;
  for (const int now : {0, 1, 2})
    for (const auto& file : files)
      if (rank(file) == now) ordered.push_back(file);
  return ordered;
}

Status stageAll(const StickTree& files, const fs::path& root, const StepObserver& step) {
  for (const auto& file : files) {
    const fs::path path = root / file.path;
    step("write " + file.path);
    if (cli::interrupted()) return Error{"stopped; " + root.string() + " is as it was"};
    std::error_code error;
    if (fs::is_directory(path, error)) return Error{path.string() + ": is a folder, not a file"};
    Status staged = makeFolder(path.parent_path());
    if (staged) staged = makeFolder(root / kUnfinished);
    if (staged) staged = writeSynced(stagedPath(root, file).string(), file.bytes);
    if (!staged) return staged;
  }
  return Done{};
}

// Takes the new files away again, which have changed nothing for the earlier ones.
Error takeBack(const std::vector<fs::path>& added, const Error& why, const fs::path& root) {
  std::error_code ignored;
  for (const auto& path : added) fs::remove(path, ignored);
  return Error{why.message + "; the earlier files of " + root.string() + " are as they were"};
}

Status renameAll(const StickTree& files, const fs::path& root, const StepObserver& step) {
  std::vector<fs::path> added;
  bool replaced = false;
  for (const auto& file : files) {
    const fs::path path = root / file.path;
    step("rename " + file.path);
    std::error_code error;
    const bool replaces = fs::exists(path, error);
    if (std::rename(stagedPath(root, file).c_str(), path.c_str()) != 0) {
      const Error why = systemError(path.string());
      if (!replaced) return takeBack(added, why, root);
      return Error{why.message + "; the files now are a mixture that no robot plays, until " +
                   "the same command goes to its end"};
    }
    replaced = replaced || replaces;
    if (!replaces) added.push_back(path);
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
  removeStaged(root);  // what a stop in the middle left
  const StickTree changed = inOrder(differing(tree, root), root);
  Status written = stageAll(changed, root, step);
  if (written) written = renameAll(changed, root, step);
  removeStaged(root);
  return written;
}

}  // namespace kelpie::stick
