// SPDX-License-Identifier: Apache-2.0
#include "behaviour/interpreter/Sources.h"

#include <sys/stat.h>

#include <filesystem>
#include <system_error>

#include "robot/core/Checksum.h"

namespace kelpie::behaviour {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMaxListed = 3;

// Time of change, size and rights, by one call of the system: a match asks this of every file once
// a second.
std::uint64_t fileStamp(const fs::path& path) {
  struct stat file {};
  if (stat(path.c_str(), &file) != 0) return 0;
  Fnv1a hash;
  for (const std::int64_t number :
       {std::int64_t{file.st_mtim.tv_sec}, std::int64_t{file.st_mtim.tv_nsec},
        std::int64_t{file.st_size}, std::int64_t{file.st_mode}})
    hash.add(&number, sizeof number);
  return hash.value();
}

bool isSource(const fs::path& path) {
  return path.extension() == ".py" && path.filename().string().front() != '.';
}

}  // namespace

SourceStamps sourceStamps(const std::string& scripts) {
  std::error_code error;
  SourceStamps stamps;
  if (!fs::exists(scripts, error)) return stamps;
  if (!fs::is_directory(scripts, error)) {
    stamps[fs::path(scripts).filename().string()] = fileStamp(scripts);
    return stamps;
  }
  const auto options = fs::directory_options::skip_permission_denied;
  for (fs::recursive_directory_iterator it(scripts, options, error), end; it != end && !error;
       it.increment(error)) {
    if (isSource(it->path()))
      stamps[it->path().lexically_relative(scripts).string()] = fileStamp(it->path());
  }
  return stamps;
}

SourceChanges changesBetween(const SourceStamps& before, const SourceStamps& now) {
  SourceChanges changes;
  for (const auto& [name, stamp] : now) {
    const auto found = before.find(name);
    if (found == before.end() || found->second != stamp) changes.edited.push_back(name);
  }
  for (const auto& [name, stamp] : before)
    if (now.count(name) == 0) changes.gone.push_back(name);
  return changes;
}

std::string listed(const std::vector<std::string>& files) {
  std::string text;
  for (std::size_t i = 0; i < files.size() && i < kMaxListed; ++i)
    text += (i > 0 ? ", " : "") + files[i];
  if (files.size() > kMaxListed)
    text += " and " + std::to_string(files.size() - kMaxListed) + " more";
  return text;
}

bool isZip(const std::string& scripts) {
  std::error_code error;
  return fs::is_regular_file(scripts, error);
}

}  // namespace kelpie::behaviour
