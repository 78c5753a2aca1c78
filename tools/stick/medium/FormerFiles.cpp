// SPDX-License-Identifier: Apache-2.0
#include "tools/stick/medium/FormerFiles.h"

#include <fmt/core.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <optional>

#include "robot/core/Checksum.h"
#include "robot/core/fields/FieldCheck.h"
#include "robot/stick/FieldReader.h"
#include "robot/stick/StickFormat.h"
#include "tools/cli/Process.h"
#include "tools/stick/Player.h"
#include "tools/stick/Programs.h"
#include "tools/stick/StickWriter.h"
#include "tools/stick/medium/SafeFiles.h"

namespace kelpie::stick {
namespace {

namespace fs = std::filesystem;

constexpr int kMaxFolders = 999;

std::string folderName(int number) { return fmt::format("FORMER.{:03}", number); }

// What a stick has now under the tree's names.
class StickNow {
 public:
  explicit StickNow(const std::string& root)
      : root_(root), binary_(readWhole((root_ / kStickPath).string())) {}

  Expected<std::string> bytes(const std::string& path) const {
    return readWhole((root_ / path).string());
  }
  bool hasOurBinary() const {
    return binary_ && binary_->size() >= kHeaderBytes &&
           std::equal(kMagic.begin(), kMagic.end(), binary_->begin());
  }
  bool hasOurAgent() const { return bool(playerOfFile((root_ / kObjectPath).string())); }
  // Whether STICK.BIN lists the file as it is, or is the file.
  bool isListed(const TreeFile& file) const;

 private:
  std::optional<StickFileList> list() const;

  fs::path root_;
  Expected<std::string> binary_;
};

// Also of a stick for another version of the program, whose configuration has other fields: header
// and list are the same.
std::optional<StickFileList> StickNow::list() const {
  if (!hasOurBinary()) return std::nullopt;
  const auto* bytes = reinterpret_cast<const std::uint8_t*>(binary_->data());
  StickHeader header;
  if (!FieldReader(bytes, binary_->size()).getStruct(header) || header.version != kVersion)
    return std::nullopt;
  const PartEntry& part = header.parts[static_cast<std::size_t>(Part::files)];
  if (part.length > binary_->size() - kHeaderBytes) return std::nullopt;
  if (crc32(bytes + kHeaderBytes, part.length) != part.crc) return std::nullopt;
  StickFileList files;
  const bool good = FieldReader(bytes + kHeaderBytes, part.length).getStruct(files);
  return good ? std::optional(files) : std::nullopt;
}

bool StickNow::isListed(const TreeFile& file) const {
  if (file.path == kStickPath) return hasOurBinary();
  const auto listed = list();
  const StickFileEntry entry = entryOf(file);
  return listed && std::any_of(listed->files.begin(), listed->files.end(), [&](const auto& one) {
           return !firstDifference(one, entry, nullptr);
         });
}

bool startsOurs(const StickTree& tree, const StickNow& now) {
  const auto old = now.bytes(kObjectListPath);
  if (!old) return true;  // it starts nothing
  return *old == findFile(tree, kObjectListPath)->bytes || now.isListed({kObjectListPath, *old});
}

bool isOurs(const StickTree& tree, const StickNow& now) {
  return startsOurs(tree, now) && (now.hasOurBinary() || now.hasOurAgent());
}

// Of the radio and of the joints: the stick has them whatever program is on it.
bool isSetting(const TreeFile& file) { return file.path == kWlanPath || file.path == kJamPath; }

bool holdsAll(const StickTree& files, const fs::path& folder) {
  return std::all_of(files.begin(), files.end(), [&](const auto& file) {
    const auto bytes = readWhole((folder / file.path).string());
    return bytes && *bytes == file.bytes;
  });
}

Status copyTo(const StickTree& files, const fs::path& folder, const std::string& name,
              const StepObserver& step) {
  for (const auto& file : files) {
    step("keep " + file.path + " in " + name);
    if (cli::interrupted()) return Error{"stopped; the stick plays as before"};
    const fs::path path = folder / file.path;
    Status kept = makeFolder(path.parent_path());
    if (kept) kept = writeSynced(path.string(), file.bytes);
    if (!kept) return kept;
  }
  return Done{};
}

// The folder gets its name when all is in it.
Status finishFolder(const fs::path& unfinished, const fs::path& folder) {
  Status synced = syncFileSystem(unfinished);
  if (synced && std::rename(unfinished.c_str(), folder.c_str()) != 0)
    synced = systemError(folder.string());
  return synced ? syncFileSystem(folder) : synced;
}

}  // namespace

Expected<StickTree> formerFiles(const StickTree& tree, const std::string& root) {
  const StickNow now(root);
  const bool ours = isOurs(tree, now);
  StickTree former;
  for (const auto& file : tree) {
    if (ours && !isSetting(file)) continue;
    const auto old = now.bytes(file.path);
    std::error_code error;
    if (!old && fs::exists(fs::path(root) / file.path, error)) return Error{old.error()};
    if (old && *old != file.bytes && !now.isListed({file.path, *old}))
      former.push_back({file.path, *old});
  }
  return former;
}

bool haveAnotherProgram(const StickTree& former) {
  return !std::all_of(former.begin(), former.end(), isSetting);
}

std::string namesOf(const StickTree& files) {
  std::string names;
  for (const auto& file : files) names += (names.empty() ? "" : ", ") + file.path;
  return names;
}

Expected<std::string> keepFormer(const StickTree& former, const std::string& root,
                                 const StepObserver& step) {
  int number = 1;
  std::error_code error;
  for (; fs::exists(fs::path(root) / folderName(number), error); ++number) {
    if (holdsAll(former, fs::path(root) / folderName(number))) return folderName(number);
    if (number == kMaxFolders) return Error{root + ": has no name left for a folder FORMER"};
  }
  const fs::path unfinished = fs::path(root) / kUnfinished;
  fs::remove_all(unfinished, error);
  const std::string name = folderName(number);
  Status kept = copyTo(former, unfinished, name, step);
  if (kept) kept = finishFolder(unfinished, fs::path(root) / name);
  if (kept) return name;
  fs::remove_all(unfinished, error);
  return Error{kept.error()};
}

}  // namespace kelpie::stick
