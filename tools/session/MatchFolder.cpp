// SPDX-License-Identifier: Apache-2.0
#include "tools/session/MatchFolder.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <regex>
#include <utility>

#include "tools/cli/WholeFile.h"
#include "tools/cli/log/ThinLog.h"

namespace kelpie::cli {
namespace {

namespace fs = std::filesystem;

constexpr int kMaxFolders = 1000;  // of one name; who plays more at once is mistaken

// Locked, or -1: no folder, or somebody else holds it.
int lockFolder(const std::string& path) {
  const int folder = open(path.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (folder < 0 || flock(folder, LOCK_EX | LOCK_NB) == 0) return folder;
  close(folder);
  return -1;
}

std::vector<fs::path> filesIn(const fs::path& folder) {
  std::vector<fs::path> files;
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end;
       entry.increment(error))
    files.push_back(entry->path());
  std::sort(files.begin(), files.end());
  return files;
}

// The number that a folder of earlier matches has for a name; 0: none.
int numberOf(const fs::path& folder) {
  const std::string name = folder.filename().string();
  const bool digits = !name.empty() && name.find_first_not_of("0123456789") == std::string::npos;
  return digits && name.size() < 9 ? std::atoi(name.c_str()) : 0;
}

Expected<Joined> joinOne(const fs::path& part, const fs::path& world, const std::string& to) {
  std::vector<std::string> halves = {part.string()};
  std::error_code error;
  if (fs::exists(world, error)) halves.push_back(world.string());
  return mergeLogs(halves, to, isThinned(part.string()));
}

}  // namespace

MatchFolder::MatchFolder(MatchFolder&& other) noexcept
    : path_(std::move(other.path_)),
      stem_(std::move(other.stem_)),
      earlier_(std::move(other.earlier_)),
      lock_(std::exchange(other.lock_, -1)),
      notes_(std::move(other.notes_)) {}

MatchFolder::~MatchFolder() {
  if (lock_ >= 0) close(lock_);
}

Expected<MatchFolder> MatchFolder::take(const std::string& wanted, const std::string& stem) {
  MatchFolder folder;
  folder.stem_ = stem;
  for (int number = 1; number <= kMaxFolders; ++number) {
    folder.path_ = number == 1 ? wanted : wanted + "-" + std::to_string(number);
    std::error_code error;
    fs::create_directories(folder.path_, error);
    if (error) return Error{"'" + folder.path_ + "': " + error.message()};
    folder.lock_ = lockFolder(folder.path_);
    if (folder.lock_ < 0) continue;
    if (number > 1)
      folder.notes_.push_back(wanted + ": a match is being played there; this one goes to " +
                              folder.path_);
    const Status begun = folder.begin();
    if (!begun) return Error{begun.error()};
    return Expected<MatchFolder>(std::move(folder));
  }
  return Error{wanted + ": matches are being played there and in all folders named after it"};
}

bool MatchFolder::isOurs(const std::string& name) const {
  const std::string robots = stem_ == "match" ? "match|red-[1-4]|blue-[1-4]" : stem_;
  const std::regex pattern(stem_ + "\\.(png|mp4)|(" + robots + ")(-[0-9]+)?\\.mcap");
  return std::regex_match(name, pattern);
}

// What a killed match left half written: its parts are whole.
void MatchFolder::removeHalves() const {
  std::error_code ignored;
  for (const auto& file : filesIn(path_)) {
    const bool part = file.extension() == ".part" && isOurs(file.stem().string());
    if (part || file.filename() == "match.part.mp4") fs::remove(file, ignored);
  }
}

Status MatchFolder::begin() {
  if (isDevice(file(stem_ + ".mcap"))) return Error{file(stem_ + ".mcap") + ": cannot be written"};
  removeHalves();
  std::error_code error;
  if (fs::exists(playing(), error)) {
    const Status kept = keepKilled();
    if (!kept) return kept;
  }
  fs::create_directory(playing(), error);
  if (error) return Error{playing() + ": " + error.message()};
  return Done{};
}

// What is older than its parts is a whole match before it, which joining them would overwrite; what
// is newer it had joined itself.
Status MatchFolder::keepKilled() {
  std::error_code error;
  const fs::file_time_type began = fs::last_write_time(playing(), error);
  if (error) return Error{playing() + ": " + error.message()};
  const Status whole = moveOlderThan(began);
  if (!whole) return whole;
  earlier_.clear();
  const auto place = placeForEarlier();
  if (!place) return Error{place.error()};
  fs::rename(playing(), *place + "/playing", error);
  if (error) return Error{playing() + ": " + error.message()};
  notes_.push_back(path_ + ": a match was killed there; its logs are in " + *place +
                   " now, and `kelpie recover " + *place + "` joins them");
  const Status joined = moveEarlier();
  earlier_.clear();
  return joined;
}

Expected<std::string> MatchFolder::placeForEarlier() {
  if (!earlier_.empty()) return earlier_;
  int newest = 0;
  for (const auto& folder : filesIn(file("earlier"))) newest = std::max(newest, numberOf(folder));
  const std::string place = file("earlier/" + std::to_string(newest + 1));
  std::error_code error;
  fs::create_directories(place, error);
  if (error) return Error{place + ": " + error.message()};
  earlier_ = place;
  return place;
}

Status MatchFolder::moveEarlier() { return moveOlderThan(fs::file_time_type::max()); }

Status MatchFolder::moveOlderThan(fs::file_time_type time) {
  for (const auto& from : filesIn(path_)) {
    const std::string name = from.filename().string();
    std::error_code error;
    if (!isOurs(name) || fs::last_write_time(from, error) >= time) continue;
    const auto place = placeForEarlier();
    if (!place) return Error{place.error()};
    fs::rename(from, fs::path(*place) / name, error);
    if (error) return Error{from.string() + ": " + error.message()};
  }
  return Done{};
}

void MatchFolder::forgetAllBut(int newest) {
  std::vector<fs::path> joined;
  std::error_code error;
  for (const auto& folder : filesIn(file("earlier")))
    if (numberOf(folder) > 0 && !fs::exists(folder / "playing", error)) joined.push_back(folder);
  std::sort(joined.begin(), joined.end(),
            [](const fs::path& a, const fs::path& b) { return numberOf(a) > numberOf(b); });
  for (std::size_t i = static_cast<std::size_t>(newest); i < joined.size(); ++i)
    fs::remove_all(joined[i], error);
}

bool isPlayedIn(const std::string& folder) {
  const int lock = lockFolder(folder);
  if (lock >= 0) close(lock);
  std::error_code error;
  return lock < 0 && fs::is_directory(folder, error);
}

void forgetParts(const std::string& folder) {
  std::error_code ignored;
  fs::remove_all(fs::path(folder) / "playing", ignored);
}

Expected<std::vector<JoinedLog>> joinWithoutWatched(const std::string& folder,
                                                    const std::string& log) {
  const std::string world = (fs::path(folder) / "playing/world.mcap").string();
  const auto kept = mergeLogs({world}, log, false);
  if (!kept) return Error{kept.error()};
  auto joined = joinParts(folder);
  if (!joined) return joined;
  joined->push_back({log, *kept});
  forgetParts(folder);
  return joined;
}

Expected<std::vector<JoinedLog>> joinParts(const std::string& folder) {
  const fs::path playing = fs::path(folder) / "playing";
  std::vector<JoinedLog> joined;
  for (const auto& part : filesIn(playing)) {
    if (part.extension() != ".mcap" || part.filename() == "world.mcap") continue;
    const std::string to = folder + "/" + part.filename().string();
    const auto done = joinOne(part, playing / "world.mcap", to);
    if (!done) return Error{done.error()};
    joined.push_back({to, *done});
  }
  if (!joined.empty()) forgetParts(folder);
  return joined;
}

}  // namespace kelpie::cli
